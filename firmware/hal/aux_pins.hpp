// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace hal {

/// Spare pins that protocol::ConfigurePins gives a function; a board has at most 16 and numbers
/// them in the order of its page in docs/hardware.
enum class PinUse : uint8_t {
  kUnused,   ///< Input with pull-up, never read; one that a motor bridge may have does not pull up.
  kDigital,  ///< Input with pull-up.
  kAnalog,   ///< Input of the converter, see adc.hpp.
  kOutput,
  kPulses,  ///< Input with pull-up whose pulses are counted, see pulses.hpp; one pin at a time.
};

/// Number of them.
uint8_t aux_pin_count();
/// False also for a pin beyond the board's last.
bool aux_pin_can(uint8_t pin, PinUse use);
/// True for a pin that the two-wire bus takes, see twi.hpp.
bool aux_pin_is_twi(uint8_t pin);
/// Takes a use that `aux_pin_can` has granted; an output starts low.
void use_aux_pin(uint8_t pin, PinUse use);

/// Levels of all pins now, a bit each; those of digital inputs mean something.
uint16_t aux_levels();
/// Level of a pin that is an output.
void set_aux_output(uint8_t pin, bool high);

}  // namespace hal
}  // namespace echomap
