// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "host/mapping/raster_map.hpp"

namespace echomap::mapping {

/// How far the walls of a map may lie from where they are: root mean square over its occupied
/// cells, in the frame of the place where the robot started (wall_rmse_m of a score).
struct ExpectedWallError {
  double median_m = 0.0;       ///< As many such maps are better as are worse.
  double nine_in_ten_m = 0.0;  ///< Nine of ten such maps are better.
};

/// What SLAM's doubt about the heading makes of a map of that extent: a map that is turned about
/// its start is wrong by so much more the farther its walls are. `heading_stddev_rad` is what SLAM
/// tells of the last pose; the factors are those of 313 maps of simulated rooms
/// (docs/measurements.md). Empty for a map without walls.
std::optional<ExpectedWallError> expected_wall_error(const RasterMap& map,
                                                     double heading_stddev_rad);

}  // namespace echomap::mapping
