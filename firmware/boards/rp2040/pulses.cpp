// SPDX-License-Identifier: MIT
#include "firmware/hal/pulses.hpp"

#include "firmware/boards/rp2040/parts.hpp"
#include "firmware/boards/rp2040/pins.hpp"

/// Each edge of a pin is latched until the handler of all pins (echo.cpp) clears it.
namespace echomap {
namespace boards {
namespace {

constexpr Pin kNone = 0xFF;

Pin watched = kNone;
volatile uint8_t counted = 0;

/// Four bits a pin: low, high, fell, rose.
Register& enables_of(Pin pin) { return pins().inte[pin / 8]; }
uint32_t fall_of(Pin pin) { return bit(static_cast<uint8_t>(pin % 8 * 4 + 2)); }

}  // namespace

void count_pulses_of(Pin pin) {
  count_no_pulses_of(watched);
  pins().intr[pin / 8] = fall_of(pin);
  watched = pin;
  set_bits(enables_of(pin), fall_of(pin));
}

void count_no_pulses_of(Pin pin) {
  if (pin == watched && pin != kNone) {
    watched = kNone;
    clear_bits(enables_of(pin), fall_of(pin));
  }
}

void take_pulse() {
  if (watched != kNone && (pins().ints[watched / 8] & fall_of(watched)) != 0) {
    pins().intr[watched / 8] = fall_of(watched);
    counted = static_cast<uint8_t>(counted + 1);
  }
}

}  // namespace boards

namespace hal {

uint8_t counted_pulses() { return boards::counted; }

}  // namespace hal
}  // namespace echomap
