// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include <avr/io.h>

/// hal/pulses by the pin change interrupt of the spare pins' port, whose mask register has the one
/// pin that is counted and no other.
namespace echomap {
namespace boards {

/// What the handler has counted.
struct PulseCount {
  volatile uint8_t counted;
  uint8_t level;  ///< The pin's bit at its last edge, or 0.
};
extern PulseCount pulse_count;

/// From now on the pin is counted, or is not; `mask` is PCMSKn.
void watch_pulses(volatile uint8_t& mask, uint8_t bit, bool on);

/// The whole of the handler. An edge between the interrupt and the first look at the pin, or
/// between two looks, is neither lost nor counted twice: the flag is cleared between them, and a
/// look that finds nothing new counts nothing.
__attribute__((always_inline)) inline void count_pulses(volatile uint8_t& pins,
                                                        volatile uint8_t& mask,
                                                        uint8_t flag) {
  uint8_t level = 0;
  do {
    level = pins & mask;
    PCIFR = flag;
    if (level == 0 && pulse_count.level != 0) {
      ++pulse_count.counted;
    }
    pulse_count.level = level;
  } while ((pins & mask) != level);
}

}  // namespace boards
}  // namespace echomap
