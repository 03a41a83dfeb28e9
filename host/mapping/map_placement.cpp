// SPDX-License-Identifier: MIT
#include "host/mapping/map_placement.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "host/geometry/angle.hpp"
#include "host/mapping/point_set.hpp"
#include "host/mapping/pose_climb.hpp"
#include "host/mapping/shifted_sums.hpp"

namespace echomap::mapping {
namespace {

using geometry::CellIndex;
using geometry::Pose2;
using Points = std::vector<Eigen::Vector2d>;

constexpr double kCoarseStepRad = 0.0524;  // 3 degrees: 0.1 m at 2 m.
/// The coarse steps are bridged by walls as wide as this.
constexpr double kCoarseStddevM = 0.12;
constexpr std::size_t kCoarsePoints = 200;
/// Of the lattice, so many of the best are looked at, and so many different ones of them refined.
constexpr std::size_t kBest = 3000;
/// Poses that are held while the best are sought.
constexpr std::size_t kMaxHeld = 100'000;
constexpr std::size_t kRefined = 24;

/// Adds what the walls of one map say of their place in the other.
void add_walls(const PlaceableMap& of,
               const PlaceableMap& on,
               const Pose2& T_on_of,
               const MapPlacementParams& params,
               MapPlacement& sum) {
  const double cell_m = of.map().resolution_m();
  for (const Eigen::Vector2d& wall_m : of.walls_m()) {
    const Eigen::Vector2d point_m = T_on_of * wall_m;
    const double common = on.wall_at(point_m, params.wall_stddev_m);
    const bool contradicts = on.is_deep_in_floor(point_m, params.floor_depth_m);
    sum.common_m += cell_m * common;
    sum.contradicting_m += contradicts ? cell_m : 0.0;
    sum.known_m += cell_m * (contradicts || on.knows(point_m) ? 1.0 : common);
  }
}

MapPlacement placed_at(const Pose2& T_previous_later,
                       const PlaceableMap& previous,
                       const PlaceableMap& later,
                       const MapPlacementParams& params) {
  MapPlacement placement{T_previous_later};
  add_walls(later, previous, T_previous_later, params, placement);
  add_walls(previous, later, T_previous_later.inverse(), params, placement);
  return placement;
}

/// What lies under a point of the later map, summed over its points for all their places on the
/// previous one.
struct Lattice {
  ShiftedSums walls;
  ShiftedSums floor;
};

Lattice lattice_of(const PlaceableMap& previous, const MapPlacementParams& params) {
  const RasterMap& map = previous.map();
  std::vector<float> for_wall;
  std::vector<float> for_floor;
  for (int y = 0; y < map.rows(); ++y) {
    for (int x = 0; x < map.columns(); ++x) {
      const Eigen::Vector2d center_m = map.center_m({x, y});
      const bool contradicts = previous.is_deep_in_floor(center_m, params.floor_depth_m);
      const double wall = previous.wall_at(center_m, kCoarseStddevM);
      for_wall.push_back(static_cast<float>(contradicts ? -MapPlacement::kContradiction : wall));
      for_floor.push_back(map.state({x, y}) == CellState::kOccupied ? -1.0F : 0.0F);
    }
  }
  return {ShiftedSums(for_wall, map.columns()), ShiftedSums(for_floor, map.columns())};
}

struct Candidate {
  Pose2 T_previous_later;
  float weight = 0.0F;
};

std::vector<CellIndex> cells_of(const RasterMap& map, const Points& points_m, const Pose2& T_to_m) {
  std::vector<CellIndex> cells;
  for (const Eigen::Vector2d& point_m : points_m) {
    cells.push_back(map.cell_at(T_to_m * point_m));
  }
  return cells;
}

/// Those that bring any of the cells onto the map.
EvenShifts shifts_onto(const RasterMap& map, const std::vector<CellIndex>& cells) {
  CellBounds bounds;
  for (const CellIndex& cell : cells) {
    bounds = united(bounds, {cell, cell});
  }
  return {{-bounds.max.x, -bounds.max.y},
          (map.columns() + bounds.max.x - bounds.min.x) / 2 + 1,
          (map.rows() + bounds.max.y - bounds.min.y) / 2 + 1};
}

float share_of(const Points& some, const Points& all) {
  return all.empty() ? 1.0F : static_cast<float>(some.size()) / static_cast<float>(all.size());
}

/// The best first.
void keep_best(std::vector<Candidate>& found) {
  const auto best = found.begin() + static_cast<std::ptrdiff_t>(std::min(kBest, found.size()));
  std::partial_sort(found.begin(), best, found.end(), [](const auto& one, const auto& other) {
    return one.weight > other.weight;
  });
  found.erase(best, found.end());
}

/// Poses on the lattice, the best first.
std::vector<Candidate> coarse_search(const PlaceableMap& previous,
                                     const PlaceableMap& later,
                                     const MapPlacementParams& params) {
  const Lattice lattice = lattice_of(previous, params);
  const Points walls_m = some_of(later.walls_m(), kCoarsePoints);
  const Points all_floor_m = later.deep_floor_m(params.floor_depth_m);
  const Points floor_m = some_of(all_floor_m, kCoarsePoints);
  // Both count in metres of the map, not in points that were taken.
  const float per_floor = static_cast<float>(MapPlacement::kContradiction) *
                          share_of(walls_m, later.walls_m()) / share_of(floor_m, all_floor_m);
  const double cell_m = previous.map().resolution_m();
  const int turns = static_cast<int>(std::ceil(2.0 * std::numbers::pi / kCoarseStepRad));
  std::vector<Candidate> found;
  for (int turn = 0; turn < turns; ++turn) {
    const Pose2 turned(0.0, 0.0, geometry::wrap_angle(turn * 2.0 * std::numbers::pi / turns));
    const auto walls = cells_of(previous.map(), walls_m, turned);
    const EvenShifts shifts = shifts_onto(previous.map(), walls);
    const auto of_walls = lattice.walls.over(walls, shifts);
    const auto of_floor = lattice.floor.over(cells_of(previous.map(), floor_m, turned), shifts);
    for (std::size_t i = 0; i < of_walls.size(); ++i) {
      if (of_walls[i] > 0.0F) {
        const int x = shifts.first.x + 2 * (static_cast<int>(i) % shifts.columns);
        const int y = shifts.first.y + 2 * (static_cast<int>(i) / shifts.columns);
        found.push_back({Pose2(x * cell_m, y * cell_m, turned.heading_rad()),
                         of_walls[i] + per_floor * of_floor[i]});
      }
    }
    if (found.size() > kMaxHeld) {
      keep_best(found);
    }
  }
  keep_best(found);
  return found;
}

/// Whether one of those places the pivot about there.
template <class Placed>
bool is_among(const Pose2& T_previous_later,
              const std::vector<Placed>& placements,
              const Eigen::Vector2d& pivot_m,
              const MapPlacementParams& params) {
  return std::any_of(placements.begin(), placements.end(), [&](const Placed& other) {
    return (T_previous_later * pivot_m - other.T_previous_later * pivot_m).norm() <
               params.apart_m &&
           std::abs(geometry::angle_between(T_previous_later.heading_rad(),
                                            other.T_previous_later.heading_rad())) <
               params.apart_rad;
  });
}

std::vector<Candidate> apart(const std::vector<Candidate>& candidates,
                             const Eigen::Vector2d& pivot_m,
                             const MapPlacementParams& params) {
  std::vector<Candidate> chosen;
  for (const Candidate& candidate : candidates) {
    if (chosen.size() < kRefined &&
        !is_among(candidate.T_previous_later, chosen, pivot_m, params)) {
      chosen.push_back(candidate);
    }
  }
  return chosen;
}

}  // namespace

std::vector<MapPlacement> find_placements(const PlaceableMap& previous,
                                          const PlaceableMap& later,
                                          const MapPlacementParams& params) {
  if (previous.walls_m().empty() || later.walls_m().empty()) {
    return {};
  }
  const Eigen::Vector2d pivot_m = mean_of(later.walls_m());
  const auto placed = [&](const Pose2& T_previous_later) {
    return placed_at(T_previous_later, previous, later, params);
  };
  std::vector<MapPlacement> found;
  for (const Candidate& candidate :
       apart(coarse_search(previous, later, params), pivot_m, params)) {
    found.push_back(
        placed(climbed(candidate.T_previous_later, pivot_m, {}, [&](const Pose2& T_previous_later) {
          return placed(T_previous_later).weight_m();
        })));
  }
  std::sort(found.begin(), found.end(), [](const auto& one, const auto& other) {
    return one.weight_m() > other.weight_m();
  });
  std::vector<MapPlacement> placements;
  for (const MapPlacement& placement : found) {
    if (!is_among(placement.T_previous_later, placements, pivot_m, params)) {
      placements.push_back(placement);
    }
  }
  return placements;
}

std::optional<MapPlacement> sure_placement(const std::vector<MapPlacement>& placements,
                                           const MapPlacementParams& params) {
  if (placements.empty()) {
    return std::nullopt;
  }
  const MapPlacement& best = placements.front();
  const double rival_m = placements.size() > 1 ? placements[1].weight_m() : 0.0;
  const bool is_sure = best.common_m >= params.min_common_m &&
                       best.weight_m() >= params.min_share * best.known_m &&
                       best.weight_m() - rival_m >= params.min_lead_m &&
                       rival_m <= params.max_rival_share * best.weight_m();
  return is_sure ? std::optional(best) : std::nullopt;
}

}  // namespace echomap::mapping
