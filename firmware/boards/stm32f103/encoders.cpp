// SPDX-License-Identifier: MIT
#include "firmware/hal/encoders.hpp"

#include "firmware/boards/stm32f103/parts.hpp"
#include "firmware/boards/stm32f103/pins.hpp"
#include "firmware/hal/events.hpp"

/// Timers 2 and 4 count every edge of a wheel by themselves (RM0008, section 15.3.12): up where A
/// leads B.
namespace echomap {
namespace boards {
namespace {

/// An edge counts when 8 samples of a clock of 9 MHz agree: shorter than 0.9 us is noise.
constexpr uint32_t kFilter = kTimCcmr1Filter8Of8 * (1U << 4 | 1U << 12);
constexpr uint32_t kInputs = kTimCcmr1Capture1FromTi1 | kTimCcmr1Capture2FromTi2;

int16_t seen_left = 0;
int16_t seen_right = 0;

void start_counter(TimerRegisters& timer) {
  timer.arr = UINT16_MAX;
  timer.ccmr1 = kInputs | kFilter;
  timer.smcr = kTimSmcrEncoderBothInputs;
  timer.cr1 = kTimCr1Enable;
}

int8_t edges_since(TimerRegisters& timer, int16_t& seen) {
  const int16_t count = static_cast<int16_t>(timer.cnt);
  const int8_t edges = static_cast<int8_t>(count - seen);
  seen = count;
  return edges;
}

}  // namespace

void start_encoders() {
  for (const Pin pin : kEncoderPins) {
    pull_up(pin);
  }
  start_counter(tim2());
  start_counter(tim4());
}

void take_encoder_edges() {
  hal::EncoderEdges& edges = hal::encoder_edges;
  edges.left = static_cast<int8_t>(edges.left + edges_since(tim2(), seen_left));
  edges.right = static_cast<int8_t>(edges.right + edges_since(tim4(), seen_right));
}

}  // namespace boards

namespace hal {

/// The timers see the pins; nobody asks for their levels.
uint8_t encoder_levels() { return 0; }

}  // namespace hal
}  // namespace echomap
