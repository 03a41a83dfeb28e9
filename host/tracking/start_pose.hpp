// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "host/geometry/pose2.hpp"

namespace echomap::tracking {

/// Where the user says that a robot starts, and how well one knows that.
struct StartPose {
  geometry::Pose2 T_map_robot;
  double stddev_m = 0.3;
  double stddev_rad = 0.2;
};

/// The pose of an option X Y DEGREES; empty for none.
std::optional<geometry::Pose2> pose_option(const std::vector<double>& numbers);

/// The start of `--at X Y DEGREES`; empty for none.
std::optional<StartPose> start_pose(const std::vector<double>& at);

}  // namespace echomap::tracking
