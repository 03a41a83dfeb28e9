// SPDX-License-Identifier: MIT
#include "firmware/hal/aux_pins.hpp"

#include <avr/io.h>

#include "firmware/boards/avr_common/parts.hpp"

namespace echomap {
namespace boards {
namespace {

/// D22 .. D29 on port A, A8 .. A15 on port K.
constexpr uint8_t kPins = 16;
constexpr uint8_t kFirstOfPortK = 8;

void write(volatile uint8_t& of_port_a, volatile uint8_t& of_port_k, uint8_t pin, bool high) {
  volatile uint8_t& place = pin < kFirstOfPortK ? of_port_a : of_port_k;
  const uint8_t bit = static_cast<uint8_t>(1U << (pin % kFirstOfPortK));
  const uint8_t others = place & static_cast<uint8_t>(~bit);
  place = high ? others | bit : others;
}

}  // namespace

uint8_t converter_channel(uint8_t pin) { return pin; }

}  // namespace boards

namespace hal {

uint8_t aux_pin_count() { return boards::kPins; }

bool aux_pin_can(uint8_t pin, PinUse use) {
  return pin < boards::kPins && (use != PinUse::kAnalog || pin >= boards::kFirstOfPortK);
}

bool aux_pin_is_twi(uint8_t /*pin*/) { return false; }

void use_aux_pin(uint8_t pin, PinUse use) {
  set_aux_output(pin, false);  // Before the direction: an output starts low.
  boards::write(DDRA, DDRK, pin, use == PinUse::kOutput);
  set_aux_output(pin, use == PinUse::kUnused || use == PinUse::kDigital);
}

uint16_t aux_levels() { return static_cast<uint16_t>(PINA | (PINK << 8)); }

void set_aux_output(uint8_t pin, bool high) { boards::write(PORTA, PORTK, pin, high); }

}  // namespace hal
}  // namespace echomap
