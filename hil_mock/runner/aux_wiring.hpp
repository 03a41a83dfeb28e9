// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>

#include "hil_mock/runner/simulated_board.hpp"
#include "hil_mock/world/robot_world.hpp"
#include "hil_mock/world/stepper_motor.hpp"
#include "hil_mock/world/wiring.hpp"

namespace echomap::runner {

/// The wires between a robot's parts and its board: spare pins and the two-wire bus.
class AuxWiring {
 public:
  /// Connects the gyro. Both must outlive this. Throws files::ConfigError where the robot has wires
  /// for other boards only.
  AuxWiring(SimulatedBoard& board, world::RobotWorld& world);

  /// Puts on every wired pin what its part says now. Pulses of the world's last step, which ends
  /// now, come a step later than they happened.
  void drive_inputs();
  /// What the board does with the coils of the pan's stepper.
  world::Coils coils() const;

 private:
  void send_pulses(unsigned pin);
  void drive_level(unsigned pin, const world::PinWire& wire);

  SimulatedBoard& board_;
  world::RobotWorld& world_;
  world::PinWires wires_;
  /// As last told to the board, so that it is told only of changes.
  std::array<std::optional<bool>, std::tuple_size_v<world::PinWires>> levels_;
};

}  // namespace echomap::runner
