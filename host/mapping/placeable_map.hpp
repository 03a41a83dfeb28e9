// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>

#include "host/mapping/raster_map.hpp"
#include "host/mapping/wall_distance.hpp"

namespace echomap::mapping {

/// A map with what it takes to lay it onto another one, or that onto it, made once for all tries.
class PlaceableMap {
 public:
  /// Throws as DistanceField.
  explicit PlaceableMap(RasterMap map);

  const RasterMap& map() const { return map_; }
  /// The centres of cells that are walls.
  const std::vector<Eigen::Vector2d>& walls_m() const { return walls_m_; }
  /// 1 on a wall, less beside it: walls lie `stddev_m` off.
  double wall_at(const Eigen::Vector2d& point_m, double stddev_m) const;
  bool knows(const Eigen::Vector2d& point_m) const;
  /// Whether it is floor, and so is all around it as far as `depth_m`, which is at most 0.5.
  bool is_deep_in_floor(const Eigen::Vector2d& point_m, double depth_m) const;
  /// The centres of cells that are.
  std::vector<Eigen::Vector2d> deep_floor_m(double depth_m) const;

 private:
  RasterMap map_;
  std::vector<Eigen::Vector2d> walls_m_;
  WallDistance to_wall_;
  WallDistance to_floors_end_;
};

}  // namespace echomap::mapping
