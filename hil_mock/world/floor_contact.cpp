// SPDX-License-Identifier: MIT
#include "hil_mock/world/floor_contact.hpp"

#include <algorithm>
#include <limits>

namespace echomap::world {

WheelSupport wheel_support(const FloorPlan& plan,
                           const geometry::Pose2& T_world_robot,
                           double track_m) {
  const Eigen::Vector2d left_m(0.0, 0.5 * track_m);
  const Eigen::Vector2d right_m(0.0, -0.5 * track_m);
  return {!plan.is_hole(T_world_robot * left_m), !plan.is_hole(T_world_robot * right_m)};
}

bool cliff_under(const FloorPlan& plan,
                 const geometry::Pose2& T_world_robot,
                 const CliffParams& sensor) {
  return plan.is_hole(T_world_robot * sensor.mount_m);
}

double hole_distance_m(const FloorPlan& plan, const Eigen::Vector2d& point_m) {
  double min_m = std::numeric_limits<double>::infinity();
  for (const Polygon& hole_m : plan.holes_m()) {
    min_m = std::min(min_m, geometry::distance_to_sides_m(hole_m, point_m));
  }
  return min_m;
}

}  // namespace echomap::world
