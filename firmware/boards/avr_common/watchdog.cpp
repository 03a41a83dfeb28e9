// SPDX-License-Identifier: MIT
#include "firmware/hal/watchdog.hpp"

#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/wdt.h>

#include "firmware/boards/avr_common/boot.hpp"
#include "firmware/boards/avr_common/parts.hpp"
#include "firmware/hal/interrupts.hpp"

namespace echomap {
namespace hal {

void start_watchdog() {
  const InterruptLock lock;
  wdt_reset();
  WDTCSR = _BV(WDCE) | _BV(WDE);
  WDTCSR = _BV(WDIE) | _BV(WDE) | _BV(WDP1);  // 64 ms, interrupt before reset.
}

void kick_watchdog() { wdt_reset(); }

ISR(WDT_vect) {
  boards::cut_motors();
  boards::remember_hang();
  for (;;) {  // Nothing else may switch them on again; the second timeout resets.
  }
}

}  // namespace hal
}  // namespace echomap
