// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

#include "host/geometry/polygon.hpp"
#include "host/mapping/floor_border.hpp"
#include "host/mapping/raster_outline.hpp"

namespace echomap::mapping {

/// The sample map of the paper's figure 6 in small: an L with one reflex corner, at (2, 1).
inline const geometry::Polygon kL{{0, 0}, {4, 0}, {4, 1}, {2, 1}, {2, 3}, {0, 3}};

inline std::vector<BorderPoint> border_of(const RasterMap& map) {
  return border_points(free_floor_rings(map).front(), map);
}

/// From the corner of `expected_m` that `outline_m` misses most.
inline double max_corner_error_m(const geometry::Polygon& expected_m,
                                 const geometry::Polygon& outline_m) {
  double max_m = 0.0;
  for (const Eigen::Vector2d& corner_m : expected_m) {
    double nearest_m = 1e9;
    for (const Eigen::Vector2d& found_m : outline_m) {
      nearest_m = std::min(nearest_m, (found_m - corner_m).norm());
    }
    max_m = std::max(max_m, nearest_m);
  }
  return max_m;
}

}  // namespace echomap::mapping
