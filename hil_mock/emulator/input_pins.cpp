// SPDX-License-Identifier: GPL-3.0-or-later
#include "hil_mock/emulator/input_pins.hpp"

#include <sim_io.h>
#include <sim_irq.h>

#include "hil_mock/emulator/chip_modules.hpp"

namespace echomap::emulator {
void InputPins::set(Pin pin, bool level) {
  Port& port = ports_[pin.port];
  const auto mask = static_cast<std::uint8_t>(1U << pin.bit);
  port.driven = static_cast<std::uint8_t>(port.driven | mask);
  port.levels = static_cast<std::uint8_t>(level ? port.levels | mask : port.levels & ~mask);
  tell_external_state(pin.port, port);
  avr_raise_irq(avr_io_getirq(&avr_, AVR_IOCTL_IOPORT_GETIRQ(pin.port), pin.bit), level ? 1 : 0);
}

void InputPins::redrive() {
  for (const auto& [name, port] : ports_) {
    std::uint8_t& pins = avr_.data[find_port(avr_, name).r_pin];
    pins = static_cast<std::uint8_t>((pins & ~port.driven) | port.levels);
  }
}

void InputPins::tell_external_state(char name, const Port& port) {
  avr_ioport_external_t state{};
  state.name = static_cast<unsigned char>(name) & 0x7FU;
  state.mask = port.driven;
  state.value = port.levels;
  avr_ioctl(&avr_, AVR_IOCTL_IOPORT_SET_EXTERNAL(name), &state);
}

}  // namespace echomap::emulator
