// SPDX-License-Identifier: MIT
#include "firmware/hal/aux_pins.hpp"

#include <avr/interrupt.h>
#include <avr/io.h>

#include "firmware/boards/avr_common/parts.hpp"
#include "firmware/boards/avr_common/pulse_interrupt.hpp"

namespace echomap {
namespace boards {
namespace {

/// D11, D12, D13 on port B, A4 and A5 on port C, then A6 and A7, which are no port pins.
constexpr uint8_t kPins = 7;
constexpr uint8_t kFirstOfPortC = 3;
constexpr uint8_t kFirstAnalogOnly = 5;
/// PCINT0 is the spare pins' alone of port B: the encoders are on port C.
constexpr uint8_t kPulsePins = kFirstOfPortC;
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
  if (use == PinUse::kPulses) {
    return pin < boards::kPulsePins;
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
  const bool is_input = use == PinUse::kDigital || use == PinUse::kPulses;
  set_aux_output(pin, pull_up_unused || is_input);
  if (pin < boards::kPulsePins) {
    boards::watch_pulses(PCMSK0, boards::bit_of(pin), use == PinUse::kPulses);
  }
}

uint16_t aux_levels() {
  const uint8_t of_port_b = static_cast<uint8_t>(PINB >> PB3) & 0x07;
  const uint8_t of_port_c = static_cast<uint8_t>(PINC >> (PC4 - boards::kFirstOfPortC)) & 0x18;
  return of_port_b | of_port_c;
}

ISR(PCINT0_vect) { boards::count_pulses(PINB, PCMSK0, _BV(PCIF0)); }

void set_aux_output(uint8_t pin, bool high) { boards::write(PORTB, PORTC, pin, high); }

}  // namespace hal
}  // namespace echomap
