// SPDX-License-Identifier: MIT
#include "firmware/boards/stm32f103/pins.hpp"

namespace echomap {
namespace boards {

void set_mode(Pin pin, PinMode mode) {
  GpioRegisters& port = port_of(pin);
  Register& configuration = pin.number < 8 ? port.crl : port.crh;
  const uint8_t shift = static_cast<uint8_t>(pin.number % 8 * 4);
  const uint32_t others = configuration & ~(uint32_t{0xF} << shift);
  configuration = others | (uint32_t{static_cast<uint8_t>(mode)} << shift);
}

void pull_up(Pin pin) {
  set_level(pin, true);
  set_mode(pin, PinMode::kInputPulled);
}

void pull_down(Pin pin) {
  set_level(pin, false);
  set_mode(pin, PinMode::kInputPulled);
}

}  // namespace boards
}  // namespace echomap
