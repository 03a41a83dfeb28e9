// SPDX-License-Identifier: MIT
#include "hil_mock/world/contact_physics.hpp"

#include <cmath>

namespace echomap::world {

geometry::Pose2 pushed_out(const FloorPlan& plan,
                           const geometry::Pose2& T_world_robot,
                           double radius_m) {
  constexpr int kRounds = 4;
  Eigen::Vector2d centre_m = T_world_robot.position_m();
  for (int round = 0; round < kRounds; ++round) {
    for (const Wall& wall : plan.walls()) {
      const Eigen::Vector2d away_m = centre_m - nearest_point(wall.segment, centre_m);
      const double distance_m = away_m.norm();
      if (distance_m > 0.0 && distance_m < radius_m) {
        centre_m += away_m * (radius_m / distance_m - 1.0);
      }
    }
  }
  return {centre_m.x(), centre_m.y(), T_world_robot.heading_rad()};
}

Contacts contacts_at(const FloorPlan& plan,
                     const geometry::Pose2& T_world_robot,
                     const BodyParams& params) {
  Contacts contacts;
  const geometry::Pose2 T_robot_world = T_world_robot.inverse();
  for (const Wall& wall : plan.walls()) {
    const Eigen::Vector2d touch_m =
        T_robot_world * nearest_point(wall.segment, T_world_robot.position_m());
    if (touch_m.norm() > params.radius_m + params.bumper_travel_m) {
      continue;
    }
    const double bearing_rad = std::atan2(touch_m.y(), touch_m.x());
    const auto within = [&](double toward_rad) {
      return toward_rad >= -params.bumper_overlap_rad && toward_rad <= params.bumper_end_rad;
    };
    contacts.left = contacts.left || within(bearing_rad);
    contacts.right = contacts.right || within(-bearing_rad);
  }
  return contacts;
}

}  // namespace echomap::world
