// SPDX-License-Identifier: MIT
#include "firmware/hal/aux_pins.hpp"

#include "firmware/boards/stm32f103/parts.hpp"
#include "firmware/boards/stm32f103/pins.hpp"

namespace echomap {
namespace boards {
namespace {

constexpr Pin kAuxPins[] = {{Port::kA, 0},
                            {Port::kA, 1},
                            {Port::kA, 2},
                            {Port::kA, 3},
                            {Port::kA, 4},
                            {Port::kA, 5},
                            {Port::kB, 0},
                            {Port::kB, 1},
                            {Port::kB, 15},
                            {Port::kB, 10},
                            {Port::kB, 11},
                            {Port::kB, 12},
                            {Port::kB, 13},
                            {Port::kA, 12}};
constexpr uint8_t kAuxPinCount = sizeof(kAuxPins) / sizeof(kAuxPins[0]);
/// A0 .. A5 are channels 0 .. 5 of the converter, B0 and B1 channels 8 and 9.
constexpr uint8_t kAnalogPins = 8;
constexpr uint8_t kAnalogPinsOfPortA = 6;
/// B10 and B11.
constexpr uint8_t kClockPinOfTwi = 9;
constexpr uint8_t kDataPinOfTwi = 10;
/// B12 and B13 may go to a motor bridge that is not configured yet.
constexpr uint8_t kLeftReverse = 11;
constexpr uint8_t kRightReverse = 12;

bool may_be_of_bridge(uint8_t aux_pin) {
  return aux_pin == kLeftReverse || aux_pin == kRightReverse;
}

}  // namespace

void start_aux_pins() {
  for (uint8_t pin = 0; pin < kAuxPinCount; ++pin) {
    hal::use_aux_pin(pin, hal::PinUse::kUnused);
  }
}

uint8_t converter_channel(uint8_t aux_pin) {
  return aux_pin < kAnalogPinsOfPortA ? aux_pin : static_cast<uint8_t>(aux_pin + 2);
}

}  // namespace boards

namespace hal {

uint8_t aux_pin_count() { return boards::kAuxPinCount; }

bool aux_pin_can(uint8_t pin, PinUse use) {
  return pin < boards::kAuxPinCount && (use != PinUse::kAnalog || pin < boards::kAnalogPins);
}

bool aux_pin_is_twi(uint8_t pin) {
  return pin == boards::kClockPinOfTwi || pin == boards::kDataPinOfTwi;
}

void use_aux_pin(uint8_t pin, PinUse use) {
  const boards::Pin chosen = boards::kAuxPins[pin];
  boards::count_no_pulses_of(chosen);
  if (use == PinUse::kAnalog) {
    boards::set_mode(chosen, boards::PinMode::kAnalog);
  } else if (use == PinUse::kOutput) {
    boards::set_level(chosen, false);
    boards::set_mode(chosen, boards::PinMode::kOutput);
  } else if (use == PinUse::kUnused && boards::may_be_of_bridge(pin)) {
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
