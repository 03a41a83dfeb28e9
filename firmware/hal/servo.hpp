// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace hal {

/// Period of the servo pulses; a new length holds from the next one on.
constexpr uint8_t kServoFrameMs = 20;

/// Length of the pan servo's pulses, 400 .. 2600 us. None are sent before the first call.
void set_servo_pulse_us(uint16_t pulse_us);

}  // namespace hal
}  // namespace echomap
