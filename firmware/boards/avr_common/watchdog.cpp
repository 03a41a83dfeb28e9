// SPDX-License-Identifier: MIT
#include "firmware/hal/watchdog.hpp"

#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/wdt.h>

#include "firmware/hal/interrupts.hpp"
#include "firmware/hal/motors.hpp"

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
  set_motor(Motor::kLeft, true, 0);
  set_motor(Motor::kRight, true, 0);
  for (;;) {  // Nothing else may switch them on again; the second timeout resets.
  }
}

}  // namespace hal
}  // namespace echomap
