// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace hal {

/// The two motors, as seen from behind the robot.
enum class Motor : uint8_t { kLeft, kRight };

/// Sets direction pin and duty (0 .. 255) of a motor. Duty 0 switches it off without a pulse; the
/// caller lets one PWM period (128 us) pass at 0 before it turns the direction round.
void set_motor(Motor motor, bool forward, uint8_t duty);

}  // namespace hal
}  // namespace echomap
