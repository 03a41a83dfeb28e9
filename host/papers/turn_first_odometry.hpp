// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "host/geometry/pose2.hpp"

namespace echomap::papers {

/// The next pose by an increment of odometry, as Akzhalova and Polichshuk have it (equations 1 to
/// 3): the robot turns first, then drives the length of the increment straight ahead. An increment
/// to the side or backwards thus goes ahead, too; localization::moved and Pose2 do better.
geometry::Pose2 turned_then_driven(const geometry::Pose2& T_map_last,
                                   const geometry::Pose2& T_last_now);

/// Where a beam of a laser at the robot's centre ended (equations 4 to 6).
Eigen::Vector2d scanned_point_m(const geometry::Pose2& T_map_robot,
                                double range_m,
                                double bearing_rad);

}  // namespace echomap::papers
