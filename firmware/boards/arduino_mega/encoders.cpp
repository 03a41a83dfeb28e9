// SPDX-License-Identifier: MIT
#include "firmware/hal/encoders.hpp"

#include <avr/interrupt.h>
#include <avr/io.h>

#include "firmware/boards/arduino_mega/pins.hpp"
#include "firmware/boards/avr_common/parts.hpp"
#include "firmware/hal/events.hpp"

namespace echomap {
namespace boards {

static_assert(kEncoderPins == 0x0F, "the low bits of the port are the levels as they stand");

void start_encoders() {
  PORTB |= kEncoderPins;
  PCMSK0 = kEncoderPins;
  PCICR = _BV(PCIE0);
}

}  // namespace boards

namespace hal {

uint8_t encoder_levels() { return PINB & boards::kEncoderPins; }

ISR(PCINT0_vect) { on_encoder_pins(PINB & boards::kEncoderPins); }

}  // namespace hal
}  // namespace echomap
