// SPDX-License-Identifier: MIT
#include "firmware/hal/encoders.hpp"

#include "firmware/boards/stm32f103/interrupt_lines.hpp"
#include "firmware/boards/stm32f103/parts.hpp"
#include "firmware/boards/stm32f103/pins.hpp"
#include "firmware/boards/stm32f103/vectors.hpp"
#include "firmware/hal/events.hpp"

namespace echomap {
namespace boards {

static_assert(kEncoderPins == 0xFU << kFirstEncoderPin, "four pins in the order of the levels");

void start_encoders() {
  constexpr uint32_t kAllOfPortB = 0x1111;
  for (uint8_t pin = kFirstEncoderPin; pin < kFirstEncoderPin + 4; ++pin) {
    pull_up({Port::kB, pin});
  }
  afio().exticr[3] = kAllOfPortB;
  exti().rtsr = kEncoderPins;
  exti().ftsr = kEncoderPins;
  exti().imr = kEncoderPins;
  enable_line(InterruptLine::kExti15To10, kEventPriority);
}

}  // namespace boards

namespace hal {

uint8_t encoder_levels() {
  constexpr boards::Pin kFirst{boards::Port::kB, boards::kFirstEncoderPin};
  return static_cast<uint8_t>(boards::port_of(kFirst).idr >> boards::kFirstEncoderPin & 0xF);
}

}  // namespace hal
}  // namespace echomap

extern "C" void on_exti15_10() {
  using namespace echomap;
  boards::exti().pr =
      boards::kEncoderPins;  // Before the levels are read: a later edge comes again.
  hal::on_encoder_pins(hal::encoder_levels());
}
