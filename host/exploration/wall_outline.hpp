// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "host/exploration/wall_walk.hpp"
#include "host/geometry/polygon.hpp"

namespace echomap::exploration {

/// What of the points along the walls is noise; ours, chosen in simulation.
struct WallOutlineParams {
  /// A wall is straight where no point is farther from it.
  double straight_m = 0.04;
  /// Shorter pieces are noise.
  double min_wall_m = 0.15;
  /// Walls with less of a turn between them are one, where all points are near it.
  double min_turn_rad = 0.26;
  /// No corner lies farther from where both of its walls were seen to end; around a reflex corner
  /// the robot sees no wall for as long as it turns.
  double corner_reach_m = 0.6;
};

/// The outline of a room from a walk that came round its walls after `round_m`: straight walls, and
/// corners where they meet. Counter-clockwise; empty where that is no polygon. Throws
/// std::invalid_argument for parameters that are not above zero.
geometry::Polygon wall_outline(const std::vector<WallStep>& steps,
                               double round_m,
                               const geometry::Pose2& T_robot_sensor,
                               const WallOutlineParams& params = {});

}  // namespace echomap::exploration
