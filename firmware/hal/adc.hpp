// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace hal {

/// Starts the conversion of a spare pin that is used as kAnalog; it is over within a millisecond.
void start_conversion(uint8_t aux_pin);
/// True once the conversion is over: `value` is then 0 .. 1023 of the supply.
bool conversion_done(uint16_t& value);

}  // namespace hal
}  // namespace echomap
