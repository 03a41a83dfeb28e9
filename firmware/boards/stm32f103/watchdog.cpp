// SPDX-License-Identifier: MIT
#include "firmware/hal/watchdog.hpp"

#include "firmware/boards/stm32f103/interrupt_lines.hpp"
#include "firmware/boards/stm32f103/parts.hpp"
#include "firmware/boards/stm32f103/vectors.hpp"

/// Two counters that a kick sets back. Timer 1 warns after 125 ms: its interrupt is above all
/// others and above the lock, so that it switches the motors off whatever hangs. The independent
/// watchdog has no warning and resets after 250 ms, by an oscillator of its own of 30 to 60 kHz
/// (data sheet), which makes that 167 to 333 ms.
namespace echomap {
namespace hal {

void start_watchdog() {
  using namespace boards;
  constexpr uint32_t kWarningMs = 125;
  constexpr uint32_t kResetMs = 250;
  TimerRegisters& timer = tim1();
  timer.psc = clock_hz() / 2000 - 1;
  timer.arr = kWarningMs * 2 - 1;
  timer.egr = kTimUpdate;
  timer.sr = 0;
  timer.dier = kTimUpdate;
  timer.cr1 = kTimCr1Enable;
  enable_line(InterruptLine::kTim1Update, kWarningPriority);
  iwdg().kr = kIwdgStart;
  iwdg().kr = kIwdgUnlock;
  iwdg().pr = 0;  // 40 kHz / 4.
  iwdg().rlr = kResetMs * 10 - 1;
  kick_watchdog();
}

void kick_watchdog() {
  boards::tim1().cnt = 0;
  boards::iwdg().kr = boards::kIwdgKick;
}

}  // namespace hal
}  // namespace echomap

extern "C" void on_tim1_update() {
  echomap::boards::cut_motors();
  for (;;) {  // Nothing else may switch them on again; the watchdog resets.
    asm volatile("");
  }
}
