// SPDX-License-Identifier: MIT
#pragma once

#include "hil_mock/world/floor_plan.hpp"
#include "hil_mock/world/part_params.hpp"
#include "host/geometry/pose2.hpp"

namespace echomap::world {

/// Infra-red detectors that say yes or no.

/// Whether a virtual wall's beam reaches a point: within its cone and length, and not behind a
/// wall.
bool beam_reaches(const FloorPlan& plan, const VirtualWall& beam, const Eigen::Vector2d& point_m);

/// Whether the detector sees a virtual wall, or a wall in the light of the robot's own emitter.
bool beam_detected(const FloorPlan& plan,
                   const geometry::Pose2& T_world_robot,
                   const BeamDetectorParams& detector);

/// Whether the wall sensor sees a wall.
bool wall_detected(const FloorPlan& plan,
                   const geometry::Pose2& T_world_robot,
                   const WallSensorParams& sensor);

}  // namespace echomap::world
