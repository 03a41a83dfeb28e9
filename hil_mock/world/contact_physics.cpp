// SPDX-License-Identifier: MIT
#include "hil_mock/world/contact_physics.hpp"

#include <cmath>

namespace echomap::world {
namespace {

/// That point, moved away from another where it is nearer to it than `min_distance_m`.
Eigen::Vector2d kept_off(const Eigen::Vector2d& point_m,
                         const Eigen::Vector2d& other_m,
                         double min_distance_m) {
  const Eigen::Vector2d away_m = point_m - other_m;
  const double distance_m = away_m.norm();
  if (distance_m > 0.0 && distance_m < min_distance_m) {
    return point_m + away_m * (min_distance_m / distance_m - 1.0);
  }
  return point_m;
}

Eigen::Vector2d nearest_point_of(const Disc& disc, const Eigen::Vector2d& point_m) {
  return disc.middle_m + disc.radius_m * (point_m - disc.middle_m).normalized();
}

/// Presses the bumpers that a point in the robot's frame touches.
void press(const Eigen::Vector2d& touch_m, const BodyParams& params, Contacts& contacts) {
  if (touch_m.norm() > params.radius_m + params.bumper_travel_m) {
    return;
  }
  const double bearing_rad = std::atan2(touch_m.y(), touch_m.x());
  const auto within = [&](double toward_rad) {
    return toward_rad >= -params.bumper_overlap_rad && toward_rad <= params.bumper_end_rad;
  };
  contacts.left = contacts.left || within(bearing_rad);
  contacts.right = contacts.right || within(-bearing_rad);
}

}  // namespace

geometry::Pose2 pushed_out(const FloorPlan& plan,
                           const geometry::Pose2& T_world_robot,
                           double radius_m) {
  constexpr int kRounds = 4;
  Eigen::Vector2d centre_m = T_world_robot.position_m();
  for (int round = 0; round < kRounds; ++round) {
    for (const Wall& wall : plan.walls_besides_robots()) {
      centre_m = kept_off(centre_m, nearest_point(wall.segment, centre_m), radius_m);
    }
    for (const Disc& robot : plan.robots()) {
      centre_m = kept_off(centre_m, robot.middle_m, robot.radius_m + radius_m);
    }
  }
  return {centre_m.x(), centre_m.y(), T_world_robot.heading_rad()};
}

Contacts contacts_at(const FloorPlan& plan,
                     const geometry::Pose2& T_world_robot,
                     const BodyParams& params) {
  Contacts contacts;
  const geometry::Pose2 T_robot_world = T_world_robot.inverse();
  for (const Wall& wall : plan.walls_besides_robots()) {
    press(
        T_robot_world * nearest_point(wall.segment, T_world_robot.position_m()), params, contacts);
  }
  for (const Disc& robot : plan.robots()) {
    press(T_robot_world * nearest_point_of(robot, T_world_robot.position_m()), params, contacts);
  }
  return contacts;
}

}  // namespace echomap::world
