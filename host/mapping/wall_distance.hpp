// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "host/mapping/distance_field.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::mapping {

/// How far it is from any point to the nearest occupied cell of a map, between the centres of cells
/// by bilinear interpolation.
class WallDistance {
 public:
  /// Distances above `max_m` count as that. Throws as DistanceField.
  WallDistance(const RasterMap& map, double max_m);

  double at_m(const Eigen::Vector2d& point_m) const;

 private:
  double max_m_;
  DistanceField field_;
};

}  // namespace echomap::mapping
