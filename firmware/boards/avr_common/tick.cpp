// SPDX-License-Identifier: MIT
#include <avr/interrupt.h>
#include <avr/io.h>

#include "firmware/boards/avr_common/parts.hpp"
#include "firmware/boards/edge_counter/edge_counter.hpp"
#include "firmware/hal/clock.hpp"
#include "firmware/hal/events.hpp"

namespace echomap {
namespace boards {

void start_tick() {
  OCR2A = F_CPU / 64 / hal::kTickHz - 1;
  TCNT2 = OCR2A / 2;  // Ticks between the overflows of the frame timer, which would delay them.
  TCCR2A = _BV(WGM21);
  TCCR2B = _BV(CS22);  // CTC, 16 MHz / 64.
  TIMSK2 = _BV(OCIE2A);
}

}  // namespace boards

namespace hal {

ISR(TIMER2_COMPA_vect) {
  boards::fold_edges();
  on_tick();
}

}  // namespace hal
}  // namespace echomap
