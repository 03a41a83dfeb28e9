// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hil_mock/runner/robot_simulation.hpp"

namespace echomap::runner {

/// Robots that share a room, at one simulated time: each meets the others' hulls where they stand.
/// Every millisecond they move in the order of their numbers, so that what happens is a function of
/// their seeds and of what their hosts say, and no two overlap. One alone is as without a team.
class RobotTeam {
 public:
  /// All at the same time and in rooms with the same walls; they must outlive this. Takes their
  /// hooks `before_step`.
  explicit RobotTeam(std::vector<RobotSimulation*> robots);

  /// Runs all of them up to `until_ns`; does nothing where that is past.
  void advance_to(std::int64_t until_ns);

  /// Somebody puts a square box down, with its middle at a point in the frame of that robot's start
  /// pose. False, and none stands there, where any robot has no place for it.
  bool put_box(std::size_t robot, const Eigen::Vector2d& middle_m, double side_m);

  std::int64_t now_ns() const { return robots_.front()->now_ns(); }

 private:
  void tell_peers(RobotSimulation& robot);

  std::vector<RobotSimulation*> robots_;
  std::vector<world::Disc> peers_;
};

}  // namespace echomap::runner
