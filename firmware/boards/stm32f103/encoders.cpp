// SPDX-License-Identifier: MIT
#include "firmware/boards/edge_counter/edge_counter.hpp"
#include "firmware/boards/stm32f103/interrupt_lines.hpp"
#include "firmware/boards/stm32f103/parts.hpp"
#include "firmware/boards/stm32f103/pins.hpp"
#include "firmware/boards/stm32f103/vectors.hpp"

namespace echomap {
namespace boards {

static_assert(kEncoderPins == 0xFU << kFirstEncoderPin, "four pins in the order of the levels");

namespace {

uint8_t levels() {
  constexpr Pin kFirst{Port::kB, kFirstEncoderPin};
  return static_cast<uint8_t>(port_of(kFirst).idr >> kFirstEncoderPin & 0xF);
}

}  // namespace

void start_encoders() {
  constexpr uint32_t kAllOfPortB = 0x1111;
  for (uint8_t pin = kFirstEncoderPin; pin < kFirstEncoderPin + 4; ++pin) {
    pull_up({Port::kB, pin});
  }
  start_edge_count(levels());
  afio().exticr[3] = kAllOfPortB;
  exti().rtsr = kEncoderPins;
  exti().ftsr = kEncoderPins;
  exti().imr = kEncoderPins;
  enable_line(InterruptLine::kExti15To10, kEventPriority);
}

}  // namespace boards

}  // namespace echomap

extern "C" void on_exti15_10() {
  using namespace echomap;
  boards::exti().pr =
      boards::kEncoderPins;  // Before the levels are read: a later edge comes again.
  boards::count_edges(boards::levels());
}
