// SPDX-License-Identifier: MIT
#include "firmware/boards/stm32f103/interrupt_lines.hpp"
#include "firmware/boards/stm32f103/parts.hpp"
#include "firmware/boards/stm32f103/pins.hpp"
#include "firmware/boards/stm32f103/vectors.hpp"
#include "firmware/hal/events.hpp"
#include "firmware/hal/interrupts.hpp"
#include "firmware/hal/sonar.hpp"

/// Timer 1 counts half microseconds, a servo frame a round. Both of its first channels look at the
/// echo pin: channel 1 captures the rising edge, channel 2 the falling one.
namespace echomap {
namespace boards {
namespace {

/// When a round began before the last trigger, on the clock of now_us, or a reading's time earlier:
/// the same error for both edges of an echo.
uint32_t round_start = 0;

/// A round is no power of two, so it cannot be told from the clock after that has wrapped.
void note_round() {
  const hal::InterruptLock lock;
  const uint32_t now = now_half_us();
  round_start = now - tim1().cnt;
}

/// When the edge captured at `count` was: less than a round ago, on the clock of now_us.
uint32_t stamp_of(uint32_t count) {
  const uint32_t now = now_half_us();
  return now - (now - round_start - count) % kFrameHalfUs;
}

}  // namespace

void start_echo() {
  TimerRegisters& timer = tim1();
  timer.psc = half_us_prescaler();
  timer.arr = kFrameHalfUs - 1;
  timer.ccmr1 = kTimCcmr1Capture1FromTi1 | kTimCcmr1Capture2FromTi1;
  timer.ccer = kTimCcerEnable1 | kTimCcerEnable2 | kTimCcerFalling2;
  timer.egr = kTimUpdate;
  timer.cr1 = kTimCr1Enable;
  enable_line(InterruptLine::kTim1Capture, kEventPriority);
  set_mode(kTriggerPin, PinMode::kOutput);
}

}  // namespace boards

namespace hal {

void trigger_sonar() {
  using namespace boards;
  constexpr uint32_t kTriggerHalfUs = 20;
  note_round();
  tim1().dier = 0;
  tim1().sr = 0;
  tim1().dier = kTimCompare1;
  set_level(kTriggerPin, true);
  const uint32_t start = now_half_us();
  while (now_half_us() - start <= kTriggerHalfUs) {
  }
  set_level(kTriggerPin, false);
}

bool echo_is_high() { return boards::level_of(boards::kEchoPin); }

}  // namespace hal
}  // namespace echomap

/// The edges come in turns, so only the one that is waited for may interrupt.
extern "C" void on_tim1_capture() {
  using namespace echomap;
  boards::TimerRegisters& timer = boards::tim1();
  const bool high = (timer.dier & boards::kTimCompare1) != 0;
  const uint32_t count = high ? timer.ccr1 : timer.ccr2;  // Reading it clears its flag.
  timer.sr = ~boards::kTimCompare2;                       // What fell before the rise is no echo.
  timer.dier = high ? boards::kTimCompare2 : 0;
  hal::on_echo_edge(high, boards::stamp_of(count));
}
