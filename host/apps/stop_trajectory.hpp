// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "host/pipeline/snapshot.hpp"
#include "host/team_map/placed_submaps.hpp"
#include "host/time/robot_time.hpp"

namespace echomap::apps {

/// What is known of the way of a robot that has told of its stops only.
inline std::vector<pipeline::StampedPose> trajectory_of(
    const std::vector<team_map::StopEnd>& ends) {
  std::vector<pipeline::StampedPose> trajectory;
  trajectory.reserve(ends.size());
  for (const team_map::StopEnd& end : ends) {
    trajectory.push_back({time::robot_time(end.stamp_s), end.T_map_robot});
  }
  return trajectory;
}

}  // namespace echomap::apps
