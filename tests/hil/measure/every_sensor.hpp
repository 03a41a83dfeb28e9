// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "hil_mock/world/mpu6050.hpp"
#include "tests/hil/robot_session.hpp"

namespace echomap::tests {

/// Everything beside wheels, bumpers and sonar that a board can read: a gyro every 10 ms, infra-red
/// channels every 50 ms, cliffs, wheel-drop, virtual wall and battery, on all spare pins. Nothing
/// is near, and no wheel hangs.
class EverySensor {
 public:
  /// Whether this says what goes on which pin of a board of that name.
  static bool knows(const std::string& board);

  /// Puts the gyro on the board's bus; this outlives the board.
  explicit EverySensor(runner::SimulatedBoard& board);
  EverySensor(const EverySensor&) = delete;
  EverySensor& operator=(const EverySensor&) = delete;

  /// Configures a robot that is connected; false where it refuses.
  bool switch_on(RobotSession& robot);

 private:
  world::Mpu6050 gyro_;
};

}  // namespace echomap::tests
