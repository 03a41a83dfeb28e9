// SPDX-License-Identifier: MIT
#include "host/mapping/placeable_map.hpp"

#include <cmath>
#include <utility>

namespace echomap::mapping {
namespace {

/// Walls farther apart do not agree at all.
constexpr double kMaxM = 0.5;

/// Everything but floor is solid, as far around the map as matters.
RasterMap without_floor(const RasterMap& map) {
  const int margin = static_cast<int>(std::ceil(kMaxM / map.resolution_m()));
  RasterMap solid =
      cut_out(map, {{-margin, -margin}, {map.columns() - 1 + margin, map.rows() - 1 + margin}});
  for (int y = 0; y < solid.rows(); ++y) {
    for (int x = 0; x < solid.columns(); ++x) {
      if (solid.state({x, y}) != CellState::kFree) {
        solid.set({x, y}, CellState::kOccupied);
      }
    }
  }
  return solid;
}

}  // namespace

PlaceableMap::PlaceableMap(RasterMap map)
    : map_(std::move(map)),
      walls_m_(centers_m(map_, CellState::kOccupied)),
      to_wall_(map_, kMaxM),
      to_floors_end_(without_floor(map_), kMaxM) {}

double PlaceableMap::wall_at(const Eigen::Vector2d& point_m, double stddev_m) const {
  const double off = to_wall_.at_m(point_m) / stddev_m;
  return std::exp(-0.5 * off * off);
}

bool PlaceableMap::knows(const Eigen::Vector2d& point_m) const {
  return map_.state(map_.cell_at(point_m)) != CellState::kUnknown;
}

bool PlaceableMap::is_deep_in_floor(const Eigen::Vector2d& point_m, double depth_m) const {
  return map_.state(map_.cell_at(point_m)) == CellState::kFree &&
         to_floors_end_.at_m(point_m) > depth_m;
}

std::vector<Eigen::Vector2d> PlaceableMap::deep_floor_m(double depth_m) const {
  std::vector<Eigen::Vector2d> deep_m = centers_m(map_, CellState::kFree);
  std::erase_if(deep_m, [&](const auto& point_m) { return !is_deep_in_floor(point_m, depth_m); });
  return deep_m;
}

}  // namespace echomap::mapping
