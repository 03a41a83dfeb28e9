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

/// Starts again without the reset of the second timeout: behind it the watchdog runs on at its
/// fastest, and the old Nano's bootloader, which does not switch it off, would never get to the
/// program (arduino/Arduino, issue 4492). A hang with interrupts locked never comes here, and is
/// reset. Registers keep their values, so the start writes whole ones; interrupts stay locked.
ISR(WDT_vect) {
  boards::cut_motors();
  boards::remember_hang();
  wdt_disable();
  asm volatile("jmp 0");
  __builtin_unreachable();
}

}  // namespace hal
}  // namespace echomap
