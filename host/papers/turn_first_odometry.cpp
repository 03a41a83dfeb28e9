// SPDX-License-Identifier: MIT
#include "host/papers/turn_first_odometry.hpp"

#include "host/geometry/unit_vector.hpp"

namespace echomap::papers {

geometry::Pose2 turned_then_driven(const geometry::Pose2& T_map_last,
                                   const geometry::Pose2& T_last_now) {
  const double heading_rad = T_map_last.heading_rad() + T_last_now.heading_rad();  // (1)
  const double drive_m = T_last_now.position_m().norm();
  const Eigen::Vector2d position_m =
      T_map_last.position_m() + drive_m * geometry::unit_vector(heading_rad);  // (2), (3)
  return {position_m.x(), position_m.y(), heading_rad};
}

Eigen::Vector2d scanned_point_m(const geometry::Pose2& T_map_robot,
                                double range_m,
                                double bearing_rad) {
  const double direction_rad = T_map_robot.heading_rad() + bearing_rad;              // (4)
  return T_map_robot.position_m() + range_m * geometry::unit_vector(direction_rad);  // (5), (6)
}

}  // namespace echomap::papers
