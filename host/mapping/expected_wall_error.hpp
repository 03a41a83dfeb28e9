// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "host/mapping/raster_map.hpp"

namespace echomap::mapping {

/// How far the walls of a map may lie from where they are: root mean square over its occupied
/// cells, in the frame of the place where the robot started (wall_rmse_m of a score).
struct ExpectedWallError {
  double median_m = 0.0;
  double p90_m = 0.0;  ///< Nine of ten such maps are better.
};

/// By the standard deviation of the heading that multiscan SLAM reports of the last pose, radians:
/// a map that is turned about its start is the more wrong the farther off its walls are. The
/// factors are those of 313 maps of simulated rooms (docs/measurements.md). Empty for a map without
/// walls, and for a deviation that is not above 0, as before the first scan.
std::optional<ExpectedWallError> expected_wall_error(const RasterMap& map,
                                                     double heading_stddev_rad);

}  // namespace echomap::mapping
