// SPDX-License-Identifier: MIT
#include "firmware/hal/aux_pins.hpp"

#include <avr/io.h>

#include "firmware/boards/avr_common/parts.hpp"

namespace echomap {
namespace boards {
namespace {

/// D11, D12, D13 on port B, A4 and A5 on port C, then A6 and A7, which are no port pins.
constexpr uint8_t kPins = 7;
constexpr uint8_t kFirstOfPortC = 3;
constexpr uint8_t kFirstAnalogOnly = 5;
/// D11 and D12 may go to a motor bridge that is not configured yet: a pull-up would be a level.
constexpr uint8_t kFirstPulledUp = 2;

uint8_t bit_of(uint8_t pin) {
  return static_cast<uint8_t>(1U << (pin < kFirstOfPortC ? pin + PB3 : pin - kFirstOfPortC + PC4));
}

/// Sets or clears the pin's bit in a register of its port; A6's and A7's bits there do nothing.
void write(volatile uint8_t& of_port_b, volatile uint8_t& of_port_c, uint8_t pin, bool high) {
  volatile uint8_t& place = pin < kFirstOfPortC ? of_port_b : of_port_c;
  const uint8_t bit = bit_of(pin);
  const uint8_t others = place & static_cast<uint8_t>(~bit);
  place = high ? others | bit : others;
}

}  // namespace

uint8_t converter_channel(uint8_t pin) { return pin - kFirstOfPortC + 4; }

}  // namespace boards

namespace hal {

uint8_t aux_pin_count() { return boards::kPins; }

bool aux_pin_can(uint8_t pin, PinUse use) {
  if (pin >= boards::kPins) {
    return false;
  }
  if (use == PinUse::kAnalog) {
    return pin >= boards::kFirstOfPortC;
  }
  return use == PinUse::kUnused || pin < boards::kFirstAnalogOnly;
}

bool aux_pin_is_twi(uint8_t pin) {
  return pin >= boards::kFirstOfPortC && pin < boards::kFirstAnalogOnly;
}

void use_aux_pin(uint8_t pin, PinUse use) {
  set_aux_output(pin, false);  // Before the direction: an output starts low.
  boards::write(DDRB, DDRC, pin, use == PinUse::kOutput);
  const bool pull_up_unused = use == PinUse::kUnused && pin >= boards::kFirstPulledUp;
  set_aux_output(pin, pull_up_unused || use == PinUse::kDigital);
}

uint16_t aux_levels() {
  const uint8_t of_port_b = static_cast<uint8_t>(PINB >> PB3) & 0x07;
  const uint8_t of_port_c = static_cast<uint8_t>(PINC >> (PC4 - boards::kFirstOfPortC)) & 0x18;
  return of_port_b | of_port_c;
}

void set_aux_output(uint8_t pin, bool high) { boards::write(PORTB, PORTC, pin, high); }

}  // namespace hal
}  // namespace echomap
