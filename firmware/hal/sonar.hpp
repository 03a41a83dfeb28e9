// SPDX-License-Identifier: MIT
#pragma once

namespace echomap {
namespace hal {

/// Pulses the trigger pin for 10 us (waits that long); the next echo edge told is a rising one.
void trigger_sonar();

/// Level of the echo pin.
bool echo_is_high();

}  // namespace hal
}  // namespace echomap
