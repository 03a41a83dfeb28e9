// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>

#include "hil_mock/runner/simulated_board.hpp"
#include "host/robot_link/link_statistics.hpp"

namespace echomap::mock_device {

/// What became of commands on a line that loses frames.
struct LossyCommands {
  int accepted = 0;
  int exactly_once = 0;        ///< Done once each, in their order, by the board's pins.
  std::uint16_t sessions = 0;  ///< More than one: the link broke, or the robot was reset.
  robot_link::LinkStatistics statistics;
};

/// Commands from the host's link to a board while `loss` of the frames are lost each way. Each
/// command is a sweep of a single ping at an angle of its own, and the board's pins tell what was
/// done: a command that was done twice would trigger the sonar twice at its angle, one that was not
/// done leaves a gap.
LossyCommands measure_commands(std::unique_ptr<runner::SimulatedBoard> board,
                               int commands,
                               double loss);

}  // namespace echomap::mock_device
