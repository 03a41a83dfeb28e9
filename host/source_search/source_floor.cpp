// SPDX-License-Identifier: MIT
#include "host/source_search/source_floor.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace echomap::source_search {

using exploration::CellValues;
using exploration::for_each_cell;
using exploration::for_each_side;
using geometry::CellIndex;
using mapping::CellState;

SourceFloor::SourceFloor(mapping::RasterMap known_map)
    : map(std::move(known_map)), floor_share(map, 1.0F) {
  for_each_cell(map, [&](CellIndex cell) {
    floor_share[cell] = map.state(cell) == CellState::kOccupied ? 0.0F : 1.0F;
  });
}

SourceFloor::SourceFloor(mapping::RasterMap known_map, const exploration::ViewGain& gain)
    : SourceFloor(std::move(known_map)) {
  is_in_the_making = true;
  for_each_cell(map, [&](CellIndex cell) {
    if (map.state(cell) == CellState::kUnknown) {
      floor_share[cell] = static_cast<float>(gain.floor_share(cell));
    }
  });
}

UnknownReach unknown_reach(const SourceFloor& floor, std::int32_t max_steps) {
  struct Reached {
    CellIndex cell;
    float share;
  };
  const mapping::RasterMap& map = floor.map;
  UnknownReach reach{CellValues<float>(map, 0.0F), CellValues<std::int32_t>(map, 0)};
  std::vector<Reached> edge;
  for_each_cell(map, [&](CellIndex cell) {
    if (map.state(cell) == CellState::kFree) {
      reach.share[cell] = 1.0F;
      edge.push_back({cell, 1.0F});
    }
  });
  for (std::int32_t step = 1; step <= max_steps && !edge.empty(); ++step) {
    std::vector<Reached> next_edge;
    for (const Reached& from : edge) {
      for_each_side(map, from.cell, [&](CellIndex next) {
        const float share = std::min(from.share, floor.floor_share[next]);
        if (map.state(next) == CellState::kUnknown && share > reach.share[next]) {
          reach.share[next] = share;
          reach.steps[next] = step;
          next_edge.push_back({next, share});
        }
      });
    }
    edge = std::move(next_edge);
  }
  return reach;
}

double floor_beyond_m2(const SourceFloor& floor, double reach_m, double shell_m, double beyond_m) {
  const double cell_m = floor.map.resolution_m();
  const auto max_steps = static_cast<std::int32_t>(reach_m / cell_m + 1e-6);
  const auto shell = static_cast<std::int32_t>(shell_m / cell_m + 1e-6);
  const UnknownReach reach = unknown_reach(floor, max_steps);
  double shell_m2 = 0.0;
  for_each_cell(floor.map, [&](CellIndex cell) {
    shell_m2 += reach.steps[cell] > max_steps - shell
                    ? static_cast<double>(reach.share[cell]) * cell_m * cell_m
                    : 0.0;
  });
  return shell_m2 * beyond_m / shell_m;
}

mapping::DistanceField distances_to_known_floor(const mapping::RasterMap& map, double max_m) {
  mapping::RasterMap floor(map.columns(), map.rows(), map.resolution_m(), map.origin_m());
  for_each_cell(map, [&](CellIndex cell) {
    if (map.state(cell) == CellState::kFree) {
      floor.set(cell, CellState::kOccupied);
    }
  });
  return {floor, max_m};
}

bool is_in_sight(const mapping::RasterMap& map,
                 const Eigen::Vector2d& from_m,
                 const Eigen::Vector2d& to_m,
                 double max_solid_m,
                 double max_unknown_m) {
  const double length_m = (to_m - from_m).norm();
  const int steps = 1 + static_cast<int>(2.0 * length_m / map.resolution_m());
  int solid = 0;
  int dark = 0;
  for (int i = 0; i < steps; ++i) {
    const CellState state = map.state(map.cell_at(from_m + (i + 0.5) / steps * (to_m - from_m)));
    solid += state == CellState::kOccupied ? 1 : 0;
    dark += state != CellState::kFree ? 1 : 0;
  }
  return solid * length_m <= max_solid_m * steps && dark * length_m <= max_unknown_m * steps;
}

}  // namespace echomap::source_search
