// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include <Eigen/Core>

#include "host/geometry/pose2.hpp"

namespace echomap::localization {

/// Which landmark of the map a sensor has seen at `point_m`, in the sensor's frame: the nearest,
/// where the robot believes to be. Empty where none is within `max_m`, or a second one is
/// within that too and could as well be meant.
std::optional<std::size_t> match_landmark(const geometry::Pose2& T_map_robot,
                                          const geometry::Pose2& T_robot_sensor,
                                          const Eigen::Vector2d& point_m,
                                          std::span<const Eigen::Vector2d> landmarks_m,
                                          double max_m);

}  // namespace echomap::localization
