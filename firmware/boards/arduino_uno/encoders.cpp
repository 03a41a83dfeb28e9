// SPDX-License-Identifier: MIT
#include <avr/interrupt.h>
#include <avr/io.h>

#include "firmware/boards/arduino_uno/pins.hpp"
#include "firmware/boards/avr_common/encoder_interrupt.hpp"
#include "firmware/boards/avr_common/parts.hpp"

namespace echomap {
namespace boards {

static_assert(kEncoderPins == 0x0F, "count_encoder_edges reads the low bits of a port");

void start_encoders() {
  PORTC |= kEncoderPins;
  PCMSK1 = kEncoderPins;
  count_edges_from(PINC & kEncoderPins);
  PCICR = _BV(PCIE1) | _BV(PCIE0);  // And a spare pin with pulses.
}

}  // namespace boards

namespace hal {

ISR(PCINT1_vect, ISR_NAKED) { boards::count_encoder_edges<_SFR_IO_ADDR(PINC)>(); }

}  // namespace hal
}  // namespace echomap
