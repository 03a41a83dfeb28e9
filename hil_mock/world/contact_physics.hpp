// SPDX-License-Identifier: MIT
#pragma once

#include "hil_mock/world/floor_plan.hpp"
#include "hil_mock/world/robot_params.hpp"
#include "host/geometry/pose2.hpp"

namespace echomap::world {

/// State of the two front bumpers.
struct Contacts {
  bool left = false;
  bool right = false;
};

/// The pose after walls and other robots have pushed the body's disc out of themselves; the heading
/// stays.
geometry::Pose2 pushed_out(const FloorPlan& plan,
                           const geometry::Pose2& T_world_robot,
                           double radius_m);

/// Which bumpers touch a wall or another robot.
Contacts contacts_at(const FloorPlan& plan,
                     const geometry::Pose2& T_world_robot,
                     const BodyParams& params);

}  // namespace echomap::world
