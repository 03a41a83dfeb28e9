// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

#include "host/geometry/pose2.hpp"

namespace echomap::tracking {

/// What an overhead camera says in a line of JSON (docs/guides/localize.md).
struct CameraFix {
  double stamp_s = 0.0;  ///< When the picture was taken, on the camera's clock.
  double sent_s = 0.0;   ///< When the line was sent, on the same.
  geometry::Pose2 T_camera_robot;
  double stddev_m = 0.02;  ///< Of x and of y.
  double stddev_rad = 0.05;
};

/// Empty for a line that is no JSON, lacks stamp_s, x_m, y_m or heading_rad, or holds something
/// that is no finite number, a deviation that is not above 0 or a sending before the picture.
std::optional<CameraFix> parse_camera_fix(std::string_view line);

}  // namespace echomap::tracking
