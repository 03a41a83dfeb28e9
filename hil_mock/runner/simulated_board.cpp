// SPDX-License-Identifier: MIT
#include "hil_mock/runner/simulated_board.hpp"

namespace echomap::runner {

MotorDuty SimulatedBoard::motor_duty(const world::MotorDriver& driver) const {
  const world::MotorDrive left = driver.drive(driver_inputs(Wheel::kLeft, driver.interface()));
  const world::MotorDrive right = driver.drive(driver_inputs(Wheel::kRight, driver.interface()));
  return {left.duty, right.duty, left.coasting, right.coasting};
}

}  // namespace echomap::runner
