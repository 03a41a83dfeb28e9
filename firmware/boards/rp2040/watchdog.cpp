// SPDX-License-Identifier: MIT
#include "firmware/hal/watchdog.hpp"

#include "firmware/boards/rp2040/interrupt_lines.hpp"
#include "firmware/boards/rp2040/parts.hpp"
#include "firmware/boards/rp2040/vectors.hpp"

/// Two counters that a kick sets back. Alarm 1 of the timer warns after 100 ms: its interrupt is
/// above all others, switches the motors off and resets. A lock holds it, though, and the watchdog
/// itself resets after 120 ms, which makes all pins inputs with pull-downs.
namespace echomap {
namespace boards {
namespace {

constexpr uint32_t kWarningUs = 100000;
constexpr uint32_t kResetUs = 120000;
constexpr uint32_t kLoad = kResetUs * 2;  // It counts twice a microsecond: erratum RP2040-E1.

}  // namespace

void reset_chip() {
  power().wdsel = kPowerAllButOscillators;
  set_bits(watchdog().ctrl, kWatchdogTrigger);
  for (;;) {  // The reset takes some cycles.
    asm volatile("");
  }
}

}  // namespace boards

namespace hal {

void start_watchdog() {
  using namespace boards;
  power().wdsel = kPowerAllButOscillators;
  kick_watchdog();
  set_bits(timer().inte, bit(1));
  enable_line(InterruptLine::kTimer1);
  watchdog().ctrl = kWatchdogEnable;
}

void kick_watchdog() {
  boards::watchdog().load = boards::kLoad;
  boards::timer().alarm[1] = boards::timer().timerawl + boards::kWarningUs;
}

}  // namespace hal
}  // namespace echomap

extern "C" void on_timer1() {
  echomap::boards::cut_motors();
  echomap::boards::reset_chip();
}
