// SPDX-License-Identifier: MIT
#include "firmware/hal/watchdog.hpp"

#include "firmware/boards/stm32f103/interrupt_lines.hpp"
#include "firmware/boards/stm32f103/parts.hpp"
#include "firmware/boards/stm32f103/vectors.hpp"

/// Two watchdogs that a kick sets back. The window watchdog warns 57 ms after the last kick: its
/// early wake-up interrupt is above all others and above the lock, so that it switches the motors
/// off whatever hangs; one step of its counter later, after 0.9 ms, it resets. The independent
/// watchdog resets after 250 ms, by an oscillator of its own of 30 to 60 kHz (data sheet), which
/// makes that 167 to 333 ms, and needs no clock of the rest of the chip.
namespace echomap {
namespace hal {
namespace {

constexpr uint32_t kFullCount = boards::kWwdgCrOn | 0x7F;

}  // namespace

void start_watchdog() {
  using namespace boards;
  constexpr uint32_t kResetMs = 250;
  kick_watchdog();
  wwdg().cfr = kWwdgCfrWarning | kWwdgCfrNoWindow |
               (runs_by_crystal() ? kWwdgCfrSteps32768 : kWwdgCfrSteps8192);
  wwdg().sr = 0;
  enable_line(InterruptLine::kWwdg, kWarningPriority);
  iwdg().kr = kIwdgStart;
  iwdg().kr = kIwdgUnlock;
  iwdg().pr = 0;  // 40 kHz / 4.
  iwdg().rlr = kResetMs * 10 - 1;
  kick_watchdog();
}

void kick_watchdog() {
  boards::wwdg().cr = kFullCount;
  boards::iwdg().kr = boards::kIwdgKick;
}

}  // namespace hal
}  // namespace echomap

extern "C" void on_wwdg() {
  echomap::boards::cut_motors();
  for (;;) {  // Nothing else may switch them on again; the watchdog resets.
    asm volatile("");
  }
}
