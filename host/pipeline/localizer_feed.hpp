// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "host/geometry/pose2.hpp"
#include "host/localization/observation_model.hpp"

namespace echomap::pipeline {

/// Where somebody says that a robot starts, with standard deviations of place and heading.
struct ToldStart {
  geometry::Pose2 T_map_robot;
  double stddev_m = 0.0;
  double stddev_rad = 0.0;
};

/// Whether the odometry has gone on by `step_m` or turned by `step_rad`.
bool has_moved(const geometry::Pose2& T_odom_before,
               const geometry::Pose2& T_odom_now,
               double step_m,
               double step_rad);

/// At most `most` of the readings, evenly picked, from where the robot is now. Those that were
/// gathered stand in the odometry's frame.
std::vector<localization::RangeReading> evenly_picked(
    std::span<const localization::RangeReading> gathered,
    const geometry::Pose2& T_odom_robot,
    std::size_t most);

/// For each bearing from the robot the reading whose axis is nearest to it, as above; none where
/// that is more than 0.1 rad off.
std::vector<localization::RangeReading> picked_at_bearings(
    std::span<const localization::RangeReading> gathered,
    const geometry::Pose2& T_odom_robot,
    std::span<const double> bearings_rad);

}  // namespace echomap::pipeline
