// SPDX-License-Identifier: MIT
#include "host/slam/landmark_sighting.hpp"

#include "host/geometry/angle.hpp"
#include "host/geometry/unit_vector.hpp"

namespace echomap::slam {

namespace {

using geometry::Pose2;

std::optional<ExpectedSighting> expected_point(const Eigen::Vector2d& point_m,
                                               const Pose2& T_map_robot,
                                               const Pose2& T_robot_sensor) {
  const auto view = models::landmark_view(T_map_robot, T_robot_sensor, point_m);
  if (!view) {
    return std::nullopt;
  }
  // To move the landmark is to move the robot the other way.
  return ExpectedSighting{
      {view->range_m, view->bearing_rad}, view->jacobian_pose, -view->jacobian_pose.leftCols<2>()};
}

ExpectedSighting expected_wall(const Eigen::Vector2d& wall,
                               const Pose2& T_map_robot,
                               const Pose2& T_robot_sensor) {
  const Pose2 T_map_sensor = T_map_robot * T_robot_sensor;
  const Eigen::Vector2d arm_m = T_map_sensor.position_m() - T_map_robot.position_m();
  const Eigen::Vector2d normal = geometry::unit_vector(wall.y());
  ExpectedSighting expected;
  expected.value = {wall.x() - normal.dot(T_map_sensor.position_m()),
                    geometry::angle_between(T_map_sensor.heading_rad(), wall.y())};
  expected.jacobian_pose << -normal.x(), -normal.y(),
      -normal.dot(geometry::perpendicular(arm_m)),  //
      0.0, 0.0, -1.0;
  expected.jacobian_landmark << 1.0,
      -geometry::perpendicular(normal).dot(T_map_sensor.position_m()),  //
      0.0, 1.0;
  return expected;
}

PlacedLandmark placed_point(const LandmarkSighting& sighting, const Pose2& T_map_robot) {
  const Pose2 T_map_sensor = T_map_robot * sighting.T_robot_sensor;
  const Eigen::Vector2d along =
      geometry::unit_vector(T_map_sensor.heading_rad() + sighting.value.y());
  const Eigen::Vector2d offset_m = sighting.value.x() * along;
  PlacedLandmark placed;
  placed.landmark = T_map_sensor.position_m() + offset_m;
  placed.jacobian_pose << Eigen::Matrix2d::Identity(),
      geometry::perpendicular(placed.landmark - T_map_robot.position_m());
  placed.by_value << along, geometry::perpendicular(offset_m);
  return placed;
}

PlacedLandmark placed_wall(const LandmarkSighting& sighting, const Pose2& T_map_robot) {
  const Pose2 T_map_sensor = T_map_robot * sighting.T_robot_sensor;
  const Eigen::Vector2d arm_m = T_map_sensor.position_m() - T_map_robot.position_m();
  const double normal_rad = geometry::wrap_angle(T_map_sensor.heading_rad() + sighting.value.y());
  const Eigen::Vector2d normal = geometry::unit_vector(normal_rad);
  const double sway_m = geometry::perpendicular(normal).dot(T_map_sensor.position_m());
  PlacedLandmark placed;
  placed.landmark = {sighting.value.x() + normal.dot(T_map_sensor.position_m()), normal_rad};
  placed.jacobian_pose << normal.x(), normal.y(),
      sway_m + normal.dot(geometry::perpendicular(arm_m)),  //
      0.0, 0.0, 1.0;
  placed.by_value << 1.0, sway_m,  //
      0.0, 1.0;
  return placed;
}

}  // namespace

std::optional<ExpectedSighting> expected_sighting(LandmarkKind kind,
                                                  const Eigen::Vector2d& landmark,
                                                  const Pose2& T_map_robot,
                                                  const Pose2& T_robot_sensor) {
  return kind == LandmarkKind::kPoint ? expected_point(landmark, T_map_robot, T_robot_sensor)
                                      : expected_wall(landmark, T_map_robot, T_robot_sensor);
}

PlacedLandmark placed_landmark(const LandmarkSighting& sighting, const Pose2& T_map_robot) {
  return sighting.kind == LandmarkKind::kPoint ? placed_point(sighting, T_map_robot)
                                               : placed_wall(sighting, T_map_robot);
}

Eigen::Vector2d innovation(const Eigen::Vector2d& seen, const Eigen::Vector2d& expected) {
  return {seen.x() - expected.x(), geometry::angle_between(expected.y(), seen.y())};
}

}  // namespace echomap::slam
