// SPDX-License-Identifier: MIT
#include "firmware/boards/avr_common/pulse_interrupt.hpp"

#include "firmware/hal/pulses.hpp"

namespace echomap {
namespace boards {

PulseCount pulse_count;

void watch_pulses(volatile uint8_t& mask, uint8_t bit, bool on) {
  if (on) {
    pulse_count.level = bit;  // At rest; a pulse that is under way now does not count.
    mask = bit;
  } else {
    mask &= static_cast<uint8_t>(~bit);
  }
}

}  // namespace boards

namespace hal {

uint8_t counted_pulses() { return boards::pulse_count.counted; }

}  // namespace hal
}  // namespace echomap
