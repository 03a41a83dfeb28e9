// SPDX-License-Identifier: MIT
#pragma once

#include "hil_mock/world/floor_plan.hpp"
#include "hil_mock/world/part_params.hpp"
#include "host/geometry/pose2.hpp"

namespace echomap::world {

/// Which wheels have floor under them.
struct WheelSupport {
  bool left = true;
  bool right = true;
};

/// Of wheels `track_m` apart; a wheel over a hole hangs.
WheelSupport wheel_support(const FloorPlan& plan,
                           const geometry::Pose2& T_world_robot,
                           double track_m);

/// Whether a cliff sensor looks into a hole.
bool cliff_under(const FloorPlan& plan,
                 const geometry::Pose2& T_world_robot,
                 const CliffParams& sensor);

/// Distance from a point to the nearest edge of a hole; infinite where there is none.
double hole_distance_m(const FloorPlan& plan, const Eigen::Vector2d& point_m);

}  // namespace echomap::world
