// SPDX-License-Identifier: MIT
#include "firmware/hal/aux_pins.hpp"

#include "firmware/boards/rp2040/parts.hpp"
#include "firmware/boards/rp2040/pins.hpp"

namespace echomap {
namespace boards {
namespace {

constexpr Pin kAuxPins[] = {
    18, 19, 22, 9, 26, 27, 28, kTwiDataPin, kTwiClockPin, kLeftReversePin, kRightReversePin};
constexpr uint8_t kAuxPinCount = sizeof(kAuxPins) / sizeof(kAuxPins[0]);

bool is_analog(Pin pin) { return pin >= kFirstAnalogPin; }

/// A motor bridge that is not configured yet may be on it.
bool may_be_of_bridge(Pin pin) { return pin == kLeftReversePin || pin == kRightReversePin; }

}  // namespace

void start_aux_pins() {
  for (uint8_t pin = 0; pin < kAuxPinCount; ++pin) {
    hal::use_aux_pin(pin, hal::PinUse::kUnused);
  }
}

uint8_t converter_channel(uint8_t aux_pin) {
  return static_cast<uint8_t>(kAuxPins[aux_pin] - kFirstAnalogPin);
}

}  // namespace boards

namespace hal {

uint8_t aux_pin_count() { return boards::kAuxPinCount; }

bool aux_pin_can(uint8_t pin, PinUse use) {
  return pin < boards::kAuxPinCount &&
         (use != PinUse::kAnalog || boards::is_analog(boards::kAuxPins[pin]));
}

bool aux_pin_is_twi(uint8_t pin) {
  return boards::kAuxPins[pin] == boards::kTwiDataPin ||
         boards::kAuxPins[pin] == boards::kTwiClockPin;
}

void use_aux_pin(uint8_t pin, PinUse use) {
  const boards::Pin chosen = boards::kAuxPins[pin];
  boards::count_no_pulses_of(chosen);
  if (use == PinUse::kAnalog) {
    boards::make_analog(chosen);
  } else if (use == PinUse::kOutput) {
    boards::set_level(chosen, false);
    boards::make_output(chosen);
  } else if (use == PinUse::kUnused && boards::may_be_of_bridge(chosen)) {
    boards::pull_down(chosen);
  } else {
    boards::pull_up(chosen);
  }
  if (use == PinUse::kPulses) {
    boards::count_pulses_of(chosen);
  }
}

uint16_t aux_levels() {
  uint16_t levels = 0;
  for (uint8_t i = 0; i < boards::kAuxPinCount; ++i) {
    if (boards::level_of(boards::kAuxPins[i])) {
      levels = static_cast<uint16_t>(levels | 1U << i);
    }
  }
  return levels;
}

void set_aux_output(uint8_t pin, bool high) { boards::set_level(boards::kAuxPins[pin], high); }

}  // namespace hal
}  // namespace echomap
