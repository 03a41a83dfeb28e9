// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace hal {

/// Pulses on the spare pin that is used as PinUse::kPulses since the start, modulo 2^8: read it at
/// least every 200 of them. A pulse counts at its falling edge; it and the gap behind it are
/// counted for sure where each lasts 50 us or more.
uint8_t counted_pulses();

}  // namespace hal
}  // namespace echomap
