// SPDX-License-Identifier: MIT
#include "firmware/hal/pulses.hpp"

#include "firmware/boards/stm32f103/interrupt_lines.hpp"
#include "firmware/boards/stm32f103/parts.hpp"
#include "firmware/boards/stm32f103/pins.hpp"
#include "firmware/boards/stm32f103/vectors.hpp"

/// A falling edge of a pin is latched by EXTI's line of the same number, until the handler clears
/// it.
namespace echomap {
namespace boards {
namespace {

constexpr Pin kNone{Port::kA, 0xFF};

Pin watched = kNone;
volatile uint8_t counted = 0;

bool is_watched(Pin pin) { return pin.port == watched.port && pin.number == watched.number; }

InterruptLine line_of(Pin pin) {
  if (pin.number < 5) {
    return static_cast<InterruptLine>(static_cast<uint8_t>(InterruptLine::kExti0) + pin.number);
  }
  return pin.number < 10 ? InterruptLine::kExti5To9 : InterruptLine::kExti10To15;
}

}  // namespace

void count_pulses_of(Pin pin) {
  Register& port_choice = afio().exticr[pin.number / 4];
  const uint8_t shift = static_cast<uint8_t>(pin.number % 4 * 4);
  const uint32_t others = port_choice & ~(uint32_t{0xF} << shift);
  exti().imr = 0;
  port_choice = others | uint32_t{static_cast<uint8_t>(pin.port)} << shift;
  exti().ftsr = bit(pin.number);
  exti().pr = bit(pin.number);
  watched = pin;
  exti().imr = bit(pin.number);
  enable_line(line_of(pin), kEventPriority);
}

void count_no_pulses_of(Pin pin) {
  if (is_watched(pin)) {
    exti().imr = 0;
    watched = kNone;
  }
}

}  // namespace boards

namespace hal {

uint8_t counted_pulses() { return boards::counted; }

}  // namespace hal
}  // namespace echomap

extern "C" void on_exti() {
  using namespace echomap::boards;
  exti().pr = exti().imr;
  counted = static_cast<uint8_t>(counted + 1);
}
