// SPDX-License-Identifier: MIT
#include "host/exploration/coverage.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <queue>
#include <utility>

#include "host/exploration/cell_values.hpp"
#include "host/exploration/planning_map.hpp"
#include "host/geometry/parameter_validator.hpp"
#include "host/mapping/distance_field.hpp"

namespace echomap::exploration {

namespace {

using geometry::CellIndex;
using mapping::CellState;
using mapping::DistanceField;
using mapping::RasterMap;

/// Where the middle of the robot can be: the open cells that hang together with a place where it
/// has been.
CellValues<char> reach_of(const RasterMap& map,
                          const CostGrid& costs,
                          const pipeline::Snapshot& snapshot) {
  CellValues<char> is_reached(map, 0);
  const auto is_open = [&](CellIndex cell) { return costs.is_open(cell); };
  for (const Eigen::Vector2d& seed_m : places_of(snapshot)) {
    const CellIndex seed = map.cell_at(seed_m);
    if (is_open(seed) && is_reached[seed] == 0) {
      joined_to(map, seed, is_reached, is_open);
    }
  }
  return is_reached;
}

/// How far each cell is from those that are marked.
DistanceField distance_to(const RasterMap& map, CellValues<char>& is_marked, double max_m) {
  RasterMap marked = map;
  for_each_cell(map, [&](CellIndex cell) {
    marked.set(cell, is_marked[cell] != 0 ? CellState::kOccupied : CellState::kUnknown);
  });
  return {marked, max_m};
}

/// Marks the unknown cells beside those of an edge that are not marked yet, and answers them.
std::vector<CellIndex> next_edge(const RasterMap& map,
                                 const std::vector<CellIndex>& edge,
                                 CellValues<char>& is_beside) {
  std::vector<CellIndex> next_cells;
  for (const CellIndex cell : edge) {
    for_each_side(map, cell, [&](CellIndex next) {
      if (is_beside[next] == 0 && map.state(next) == CellState::kUnknown) {
        is_beside[next] = 1;
        next_cells.push_back(next);
      }
    });
  }
  return next_cells;
}

/// Marks the unknown cells within so many steps of floor that was seen.
CellValues<char> unknown_beside(const RasterMap& map, CellValues<char>& is_seen, int steps) {
  CellValues<char> is_beside(map, 0);
  std::vector<CellIndex> edge;
  for_each_cell(map, [&](CellIndex cell) {
    if (is_seen[cell] != 0) {
      edge.push_back(cell);
    }
  });
  for (int step = 0; step < steps; ++step) {
    edge = next_edge(map, edge, is_beside);
  }
  return is_beside;
}

/// The floor that is expected in unknown cells beside what was seen.
double unseen_m2(const RasterMap& map, CellValues<char>& is_beside, const ViewGain& gain) {
  double area_m2 = 0.0;
  for_each_cell(
      map, [&](CellIndex cell) { area_m2 += is_beside[cell] != 0 ? gain.floor_share(cell) : 0.0; });
  return area_m2 * map.resolution_m() * map.resolution_m();
}

/// Whether the robot can stand right before a wall: it fits into no door in the tip of a room.
bool can_stand_before(const UnobservedWall& wall,
                      const RasterMap& map,
                      const CellValues<char>& is_reached,
                      const CostGridParams& costs) {
  const double stand_m = costs.robot_radius_m + costs.clearance_m + map.resolution_m();
  const CellIndex before = map.cell_at(before_m(wall, stand_m));
  return map.contains(before) && is_reached[before] != 0;
}

/// What is expected behind walls that nobody has heard.
double behind_unobserved_m2(const RasterMap& map,
                            const CellValues<char>& is_reached,
                            const CostGridParams& costs,
                            const ViewGain& gain) {
  double area_m2 = 0.0;
  for (const UnobservedWall& unobserved : gain.unobserved()) {
    area_m2 += can_stand_before(unobserved, map, is_reached, costs) ? unobserved.floor_m2 : 0.0;
  }
  return area_m2;
}

/// What may be a door, as far as any stop could tell; each once, the widest first.
std::vector<geometry::Segment> doors_left(const RasterMap& map,
                                          const CellValues<char>& is_reached,
                                          const pipeline::Snapshot& snapshot,
                                          const CoverageParams& params) {
  auto doors =
      possible_doors(map, snapshot.features->unheard, views_of(*snapshot.scans), params.doors);
  std::ranges::stable_sort(doors, std::ranges::greater{}, &geometry::Segment::length_m);
  std::vector<geometry::Segment> left;
  for (const geometry::Segment& door : doors) {
    const auto is_same = [&](const geometry::Segment& other) {
      return (before_m({other}, 0.0) - before_m({door}, 0.0)).norm() < params.doors.apart_m;
    };
    if (can_stand_before({door}, map, is_reached, params.costs) &&
        std::ranges::none_of(left, is_same)) {
      left.push_back(door);
    }
  }
  return left;
}

/// The pieces of it that count for something.
std::vector<UnseenPlace> unseen_places(const RasterMap& map,
                                       CellValues<char>& is_beside,
                                       const ViewGain& gain,
                                       const CoverageParams& params) {
  const double cell_m2 = map.resolution_m() * map.resolution_m();
  const auto counts = [&](CellIndex cell) {
    return is_beside[cell] != 0 && gain.floor_share(cell) >= params.min_floor_share;
  };
  std::vector<UnseenPlace> places;
  CellValues<char> is_taken(map, 0);
  for_each_cell(map, [&](CellIndex seed) {
    if (is_taken[seed] != 0 || !counts(seed)) {
      return;
    }
    UnseenPlace place;
    for (const CellIndex cell : joined_to(map, seed, is_taken, counts)) {
      const double area_m2 = cell_m2 * gain.floor_share(cell);
      place.at_m += area_m2 * map.center_m(cell);
      place.area_m2 += area_m2;
    }
    place.at_m /= place.area_m2;
    if (place.area_m2 >= params.min_place_m2) {
      places.push_back(place);
    }
  });
  return places;
}

/// The way over free floor, however narrow, that keeps farthest from what is occupied: where it
/// comes nearest. Searched from `from` to the nearest cell that `is_goal`.
template <class IsGoal>
std::optional<NarrowGap> narrowest_on_the_widest_way(const RasterMap& map,
                                                     const DistanceField& to_occupied,
                                                     CellIndex from,
                                                     IsGoal&& is_goal) {
  struct Step {
    float clearance_cells;
    CellIndex cell;
    CellIndex narrowest;
    bool operator<(const Step& other) const { return clearance_cells < other.clearance_cells; }
  };
  CellValues<char> is_done(map, 0);
  std::priority_queue<Step> steps;
  steps.push({to_occupied.distance_cells(from), from, from});
  while (!steps.empty()) {
    const Step step = steps.top();
    steps.pop();
    if (std::exchange(is_done[step.cell], 1) != 0) {
      continue;
    }
    if (is_goal(step.cell)) {
      const double clearance_m =
          (static_cast<double>(step.clearance_cells) - 0.5) * map.resolution_m();
      return NarrowGap{map.center_m(step.narrowest), 2.0 * std::max(0.0, clearance_m), 0.0};
    }
    for_each_side(map, step.cell, [&](CellIndex next) {
      if (is_done[next] == 0 && map.state(next) == CellState::kFree) {
        const float clearance_cells = to_occupied.distance_cells(next);
        const bool is_narrower = clearance_cells < step.clearance_cells;
        steps.push({std::min(clearance_cells, step.clearance_cells),
                    next,
                    is_narrower ? next : step.narrowest});
      }
    });
  }
  return std::nullopt;
}

/// Of each piece of free floor that was not seen from the reach of the robot and leads there.
std::vector<NarrowGap> narrow_gaps(const RasterMap& map,
                                   CellValues<char>& is_reached,
                                   CellValues<char>& is_seen,
                                   const CoverageParams& params) {
  const double far_m = 2.0 * (params.costs.robot_radius_m + params.costs.clearance_m) + 0.5;
  const DistanceField to_occupied(map, far_m);
  const double cell_m2 = map.resolution_m() * map.resolution_m();
  std::vector<NarrowGap> gaps;
  CellValues<char> is_taken(map, 0);
  for_each_cell(map, [&](CellIndex seed) {
    const auto is_behind = [&](CellIndex cell) {
      return map.state(cell) == CellState::kFree && is_seen[cell] == 0;
    };
    if (is_taken[seed] != 0 || !is_behind(seed)) {
      return;
    }
    const auto piece = joined_to(map, seed, is_taken, is_behind);
    const double area_m2 = cell_m2 * static_cast<double>(piece.size());
    if (area_m2 < params.min_place_m2) {
      return;
    }
    const CellIndex widest =
        *std::max_element(piece.begin(), piece.end(), [&](CellIndex one, CellIndex other) {
          return to_occupied.distance_cells(one) < to_occupied.distance_cells(other);
        });
    auto gap = narrowest_on_the_widest_way(
        map, to_occupied, widest, [&](CellIndex cell) { return is_reached[cell] != 0; });
    if (gap) {
      gap->behind_m2 = area_m2;
      gaps.push_back(*gap);
    }
  });
  return gaps;
}

}  // namespace

double Coverage::share() const { return seen_m2 > 0.0 ? seen_m2 / (seen_m2 + unseen_m2) : 0.0; }

Coverage coverage_of(const pipeline::Snapshot& snapshot, const CoverageParams& params) {
  geometry::ParameterValidator("coverage")
      .positive("corner_radii", params.corner_radii)
      .at_least("min_place_m2", params.min_place_m2, 0.0);
  const RasterMap map = planning_map(snapshot, params.gain.depth_m, params.costs.robot_radius_m);
  CellValues<char> is_reached = reach_of(map, costs_on(map, snapshot, params.costs), snapshot);
  const double reach_m = params.corner_radii * params.costs.robot_radius_m;
  const DistanceField to_reach = distance_to(map, is_reached, reach_m + map.resolution_m());
  const auto reach_cells = static_cast<float>(reach_m / map.resolution_m());
  CellValues<char> is_seen(map, 0);
  Coverage coverage;
  for_each_cell(map, [&](CellIndex cell) {
    if (map.state(cell) == CellState::kFree && to_reach.distance_cells(cell) <= reach_cells) {
      is_seen[cell] = 1;
      coverage.seen_m2 += map.resolution_m() * map.resolution_m();
    }
  });

  const auto steps = static_cast<int>(params.gain.depth_m / map.resolution_m());
  CellValues<char> is_beside = unknown_beside(map, is_seen, steps);
  const ViewGain gain(map, views_of(*snapshot.scans), snapshot.features->unobserved, params.gain);
  coverage.places = unseen_places(map, is_beside, gain, params);
  coverage.unseen_m2 =
      unseen_m2(map, is_beside, gain) + behind_unobserved_m2(map, is_reached, params.costs, gain);
  std::stable_sort(coverage.places.begin(), coverage.places.end(), [](auto& one, auto& other) {
    return one.area_m2 > other.area_m2;
  });
  coverage.doors = doors_left(map, is_reached, snapshot, params);
  coverage.gaps = narrow_gaps(map, is_reached, is_seen, params);
  std::stable_sort(coverage.gaps.begin(), coverage.gaps.end(), [](auto& one, auto& other) {
    return one.behind_m2 > other.behind_m2;
  });
  return coverage;
}

}  // namespace echomap::exploration
