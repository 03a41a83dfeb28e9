// SPDX-License-Identifier: MIT
#include <avr/interrupt.h>
#include <avr/io.h>

#include "firmware/boards/arduino_mega/pins.hpp"
#include "firmware/boards/avr_common/encoder_interrupt.hpp"
#include "firmware/boards/avr_common/parts.hpp"

namespace echomap {
namespace boards {

static_assert(kEncoderPins == 0x0F, "count_encoder_edges reads the low bits of a port");

void start_encoders() {
  PORTB |= kEncoderPins;
  PCMSK0 = kEncoderPins;
  count_edges_from(PINB & kEncoderPins);
  PCICR = _BV(PCIE0) | _BV(PCIE2);  // And a spare pin with pulses.
}

}  // namespace boards

namespace hal {

ISR(PCINT0_vect, ISR_NAKED) { boards::count_encoder_edges<_SFR_IO_ADDR(PINB)>(); }

}  // namespace hal
}  // namespace echomap
