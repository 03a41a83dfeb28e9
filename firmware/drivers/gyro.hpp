// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/drivers/gyro_angle.hpp"
#include "firmware/drivers/gyro_mpu6050.hpp"
#include "firmware/hal/twi.hpp"
#include "firmware/hal/yaw_gyro.hpp"

namespace echomap {
namespace drivers {

/// What measures turns, an MPU-6050 on the two-wire bus or a gyro of the board's own, by board; both
/// in the MPU-6050's numbers.
class Gyro {
 public:
  /// True on a board that can have one.
  static bool can_be() { return hal::has_yaw_gyro() || hal::has_twi(); }
  /// True where it shares its pins with the two-wire bus.
  static bool needs_twi() { return !hal::has_yaw_gyro(); }

  /// Once a millisecond.
  void tick(const protocol::ConfigureSensors& settings) {
    if (hal::has_yaw_gyro()) {
      angle_.tick(settings);
    } else {
      chip_.tick(settings);
    }
  }
  /// Sets it up anew, with new settings.
  void restart() {
    if (hal::has_yaw_gyro()) {
      angle_.restart();
    } else {
      chip_.restart();
    }
  }

  /// As GyroMpu6050 has them.
  int32_t yaw_sum() const { return hal::has_yaw_gyro() ? angle_.yaw_sum() : chip_.yaw_sum(); }
  uint16_t samples() const { return hal::has_yaw_gyro() ? angle_.samples() : chip_.samples(); }
  uint16_t errors() const { return hal::has_yaw_gyro() ? angle_.errors() : chip_.errors(); }

 private:
  GyroMpu6050 chip_;
  GyroAngle angle_;
};

}  // namespace drivers
}  // namespace echomap
