// SPDX-License-Identifier: MIT
#include "host/models/landmark_view.hpp"

#include <cmath>

#include "host/geometry/angle.hpp"
#include "host/geometry/unit_vector.hpp"

namespace echomap::models {

namespace {

constexpr double kNearestM = 1e-6;

}  // namespace

std::optional<LandmarkView> landmark_view(const geometry::Pose2& T_map_robot,
                                          const geometry::Pose2& T_robot_sensor,
                                          const Eigen::Vector2d& landmark_m) {
  const geometry::Pose2 T_map_sensor = T_map_robot * T_robot_sensor;
  const Eigen::Vector2d offset_m = landmark_m - T_map_sensor.position_m();
  const double range_m = offset_m.norm();
  if (range_m < kNearestM) {
    return std::nullopt;
  }
  const Eigen::Vector2d along = offset_m / range_m;
  const Eigen::Vector2d across = geometry::perpendicular(along);
  // A turn of the robot swings the sensor around its centre.
  const Eigen::Vector2d arm_m = T_map_sensor.position_m() - T_map_robot.position_m();
  const Eigen::Vector2d swing_m = geometry::perpendicular(arm_m);
  LandmarkView view;
  view.range_m = range_m;
  view.bearing_rad =
      geometry::angle_between(T_map_sensor.heading_rad(), std::atan2(offset_m.y(), offset_m.x()));
  view.jacobian_pose << -along.x(), -along.y(), -along.dot(swing_m),  //
      -across.x() / range_m, -across.y() / range_m, -across.dot(swing_m) / range_m - 1.0;
  return view;
}

}  // namespace echomap::models
