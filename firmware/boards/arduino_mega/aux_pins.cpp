// SPDX-License-Identifier: MIT
#include "firmware/hal/aux_pins.hpp"

#include <avr/interrupt.h>
#include <avr/io.h>

#include "firmware/boards/avr_common/parts.hpp"
#include "firmware/boards/avr_common/pulse_interrupt.hpp"

namespace echomap {
namespace boards {
namespace {

/// D22 .. D29 on port A, A8 .. A15 on port K.
constexpr uint8_t kPins = 16;
constexpr uint8_t kFirstOfPortK = 8;

uint8_t bit_of(uint8_t pin) { return static_cast<uint8_t>(1U << (pin % kFirstOfPortK)); }

void write(volatile uint8_t& of_port_a, volatile uint8_t& of_port_k, uint8_t pin, bool high) {
  volatile uint8_t& place = pin < kFirstOfPortK ? of_port_a : of_port_k;
  const uint8_t bit = bit_of(pin);
  const uint8_t others = place & static_cast<uint8_t>(~bit);
  place = high ? others | bit : others;
}

}  // namespace

uint8_t converter_channel(uint8_t pin) { return pin; }

}  // namespace boards

namespace hal {

uint8_t aux_pin_count() { return boards::kPins; }

bool aux_pin_can(uint8_t pin, PinUse use) {
  const bool of_port_k = use == PinUse::kAnalog || use == PinUse::kPulses;
  return pin < boards::kPins && (!of_port_k || pin >= boards::kFirstOfPortK);
}

bool aux_pin_is_twi(uint8_t /*pin*/) { return false; }

void use_aux_pin(uint8_t pin, PinUse use) {
  set_aux_output(pin, false);  // Before the direction: an output starts low.
  boards::write(DDRA, DDRK, pin, use == PinUse::kOutput);
  set_aux_output(pin, use != PinUse::kOutput && use != PinUse::kAnalog);
  if (pin >= boards::kFirstOfPortK) {
    boards::watch_pulses(PCMSK2, boards::bit_of(pin), use == PinUse::kPulses);
  }
}

uint16_t aux_levels() { return static_cast<uint16_t>(PINA | (PINK << 8)); }

ISR(PCINT2_vect) { boards::count_pulses(PINK, PCMSK2, _BV(PCIF2)); }

void set_aux_output(uint8_t pin, bool high) { boards::write(PORTA, PORTK, pin, high); }

}  // namespace hal
}  // namespace echomap
