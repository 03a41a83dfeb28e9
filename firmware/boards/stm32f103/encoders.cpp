// SPDX-License-Identifier: MIT
#include "firmware/hal/encoders.hpp"

#include "firmware/boards/stm32f103/parts.hpp"
#include "firmware/boards/stm32f103/pins.hpp"
#include "firmware/hal/clock.hpp"

/// Timers 2 and 4 count every edge of a wheel by themselves (RM0008, section 15.3.12): up where A
/// leads B.
namespace echomap {
namespace boards {
namespace {

/// An edge counts when 8 samples of a clock of 9 MHz agree: shorter than 0.9 us is noise.
constexpr uint32_t kFilter = kTimCcmr1Filter8Of8 * (1U << 4 | 1U << 12);
constexpr uint32_t kInputs = kTimCcmr1Capture1FromTi1 | kTimCcmr1Capture2FromTi2;

void start_counter(TimerRegisters& timer) {
  timer.arr = UINT16_MAX;
  timer.ccmr1 = kInputs | kFilter;
  timer.smcr = kTimSmcrEncoderBothInputs;
  timer.cr1 = kTimCr1Enable;
}

}  // namespace

void start_encoders() {
  for (const Pin pin : kEncoderPins) {
    pull_up(pin);
  }
  start_counter(tim2());
  start_counter(tim4());
}

}  // namespace boards

namespace hal {

EncoderReading read_encoders() {
  return EncoderReading{static_cast<int16_t>(boards::tim2().cnt),
                        static_cast<int16_t>(boards::tim4().cnt)};
}

uint32_t encoders_read_at_us() { return now_us(); }

LostSteps lost_encoder_steps() { return LostSteps{0, 0}; }

bool encoders_tell_lost_steps() { return false; }

}  // namespace hal
}  // namespace echomap
