// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include <Eigen/Core>

#include "host/geometry/pose2.hpp"

namespace echomap::models {

/// What a landmark is: two numbers either way.
enum class LandmarkKind : std::uint8_t {
  kPoint,  ///< In the map x and y (m); seen as range (m) and bearing (rad).
  /// A straight wall, seen from one side: the points p with n . p = offset, n the unit vector from
  /// the robot's side into the wall. In the map, and as seen: offset (m) and direction of n (rad).
  kWall,
};

/// How a landmark is seen from a pose, and how that changes with the pose.
struct LandmarkView {
  double range_m = 0.0;
  double bearing_rad = 0.0;
  /// Of range and bearing by the robot's x, y and heading.
  Eigen::Matrix<double, 2, 3> jacobian_pose = Eigen::Matrix<double, 2, 3>::Zero();
};

/// Range and bearing of a point of the map (Thrun, Burgard and Fox 2005, table 7.2, lines 10 to
/// 13, with a sensor that need not sit in the robot's centre). Empty where the sensor stands on the
/// point: it has no bearing there.
std::optional<LandmarkView> landmark_view(const geometry::Pose2& T_map_robot,
                                          const geometry::Pose2& T_robot_sensor,
                                          const Eigen::Vector2d& landmark_m);

}  // namespace echomap::models
