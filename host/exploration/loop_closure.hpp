// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "host/exploration/wall_walk.hpp"

namespace echomap::exploration {

/// How the end of a walk is laid onto its beginning; ours, chosen in simulation.
struct LoopClosureParams {
  /// What is seen at the end farther than this from a wall of the beginning is none of it.
  double reach_m = 0.3;
  /// How far the odometry may have gone astray, where the walls do not tell.
  double position_stddev_m = 0.15;
  double heading_stddev_rad = 0.10;
  /// Of a point of a wall.
  double wall_stddev_m = 0.01;
  /// Walls of the beginning are looked for so much farther on than its end goes.
  double lead_m = 0.4;
  int rounds = 30;
};

/// A walk that came round after `round_m` and went on along the walls of its beginning: the same
/// walk with those walls where they were the first time. The turn that the odometry was off by is
/// spread evenly over the way, and then the place; ours, as the paper only says that both ends are
/// almost the same. Unchanged where the end shows no wall of the beginning. Throws
/// std::invalid_argument for parameters that are not above zero.
std::vector<WallStep> closed_walk(std::vector<WallStep> steps,
                                  double round_m,
                                  const geometry::Pose2& T_robot_sensor,
                                  const LoopClosureParams& params = {});

}  // namespace echomap::exploration
