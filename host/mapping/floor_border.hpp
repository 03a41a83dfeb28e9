// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "host/geometry/polygon.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::mapping {

/// A piece of the floor's border, one edge of a cell long.
struct BorderPoint {
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();  ///< Middle of that edge.
  /// Mean direction out of the floor of the border around it, not of unit length.
  Eigen::Vector2d outward = Eigen::Vector2d::Zero();
  /// Whether there are occupied cells behind it. Behind the others all is unknown.
  bool is_occupied = false;
};

/// The pieces of a ring of `free_floor_rings` of that map, in its order.
std::vector<BorderPoint> border_points(const geometry::Polygon& border_m, const RasterMap& map);

/// Between a point of a border and the one before it.
Eigen::Vector2d joint_m(const std::vector<BorderPoint>& border, std::size_t point);

/// Whether all cells on the way from a point of the border to a place beyond it are unknown, but
/// for the last `wall_m` of it.
bool is_unknown_up_to(const RasterMap& map,
                      const Eigen::Vector2d& border_m,
                      const Eigen::Vector2d& place_m,
                      double wall_m);

}  // namespace echomap::mapping
