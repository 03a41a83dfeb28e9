// SPDX-License-Identifier: MIT
#include "firmware/boards/stm32f103/interrupt_lines.hpp"
#include "firmware/boards/stm32f103/parts.hpp"
#include "firmware/boards/stm32f103/vectors.hpp"
#include "firmware/hal/clock.hpp"
#include "firmware/hal/events.hpp"
#include "firmware/hal/interrupts.hpp"

namespace echomap {
namespace boards {
namespace {

volatile uint32_t ticks = 0;
uint32_t period_cycles = 0;
uint32_t cycles_per_half_us = 0;

/// The clock as ticks and the cycles since the last of them.
struct Instant {
  uint32_t ticks;
  uint32_t cycles;
};

/// A tick that nobody has served yet belongs before a low count and after a high one.
Instant now() {
  const hal::InterruptLock lock;
  const uint32_t cycles = period_cycles - 1 - sys_tick().val;
  const bool tick_waits = (scb().icsr & kScbIcsrTickPending) != 0;
  const bool is_low = cycles < period_cycles / 2;
  return {tick_waits && is_low ? ticks + 1 : ticks, cycles};
}

}  // namespace

void start_tick() {
  period_cycles = clock_hz() / hal::kTickHz;
  cycles_per_half_us = half_us_prescaler() + 1;
  scb().shpr[kScbShprTick] = kEventPriority;
  sys_tick().load = period_cycles - 1;
  sys_tick().val = 0;
  sys_tick().ctrl = kSysTickEnable | kSysTickInterrupt | kSysTickCoreClock;
}

uint32_t now_half_us() {
  const Instant instant = now();
  return instant.ticks * 2000 + instant.cycles / cycles_per_half_us;
}

}  // namespace boards

namespace hal {

uint32_t now_us() {
  const boards::Instant instant = boards::now();
  return instant.ticks * 1000 + instant.cycles / (2 * boards::cycles_per_half_us);
}

}  // namespace hal
}  // namespace echomap

extern "C" void on_sys_tick() {
  echomap::boards::ticks = echomap::boards::ticks + 1;
  echomap::hal::on_tick();
}
