// SPDX-License-Identifier: GPL-2.0-or-later
#include "hil_mock/unicorn/gpio_port.hpp"

namespace echomap::unicorn {
namespace {

constexpr std::uint32_t kCrl = 0x00;
constexpr std::uint32_t kCrh = 0x04;
constexpr std::uint32_t kIdr = 0x08;
constexpr std::uint32_t kOdr = 0x0C;
constexpr std::uint32_t kBsrr = 0x10;
constexpr std::uint32_t kBrr = 0x14;
constexpr std::uint32_t kAllInputsFloat = 0x44444444;
constexpr std::uint32_t kPins = 0xFFFF;
constexpr unsigned kPulled = 0x8;
constexpr unsigned kAnalog = 0x0;

}  // namespace

void GpioPort::drive(std::uint8_t pin, bool high) {
  driven_ |= bit(pin);
  driven_levels_ = (driven_levels_ & ~bit(pin)) | (high ? bit(pin) : 0);
  report_changes();
}

void GpioPort::take_away(std::uint32_t pins) {
  taken_ = pins;
  report_changes();
}

world::PinSignal GpioPort::signal(std::uint8_t pin) const {
  if (drives(pin)) {
    return world::level(is_driven_high(pin));
  }
  const bool by_program = mode(pin) == kPulled && (output_ & bit(pin)) != 0;
  return is_taken(pin) || by_program ? world::pulled_up() : world::floating();
}

std::uint32_t GpioPort::read(std::uint32_t offset) {
  switch (offset) {
    case kCrl:
    case kCrh:
      return configuration_[offset / 4];
    case kIdr:
      return levels();
    case kOdr:
      return output_;
    default:
      return 0;
  }
}

void GpioPort::write(std::uint32_t offset, std::uint32_t value) {
  if (offset == kCrl || offset == kCrh) {
    configuration_[offset / 4] = value;
    report_changes();
  } else if (offset == kOdr) {
    set_output(value);
  } else if (offset == kBsrr) {
    set_output((output_ & ~(value >> 16)) | (value & kPins));
  } else if (offset == kBrr) {
    set_output(output_ & ~value);
  }
}

void GpioPort::reset() {
  configuration_[0] = configuration_[1] = kAllInputsFloat;
  set_output(0);
}

unsigned GpioPort::mode(std::uint8_t pin) const {
  return configuration_[pin / 8] >> (pin % 8 * 4) & 0xFU;
}

std::uint32_t GpioPort::levels() const {
  std::uint32_t levels = 0;
  for (std::uint8_t pin = 0; pin < 16; ++pin) {
    levels |= level_of(pin) ? bit(pin) : 0;
  }
  return levels;
}

bool GpioPort::level_of(std::uint8_t pin) const {
  if (mode(pin) == kAnalog || is_alternate(pin) || is_taken(pin)) {
    return false;
  }
  if (drives(pin)) {
    return (output_ & bit(pin)) != 0;
  }
  if ((driven_ & bit(pin)) != 0) {
    return (driven_levels_ & bit(pin)) != 0;
  }
  return mode(pin) == kPulled && (output_ & bit(pin)) != 0;
}

void GpioPort::set_output(std::uint32_t value) {
  output_ = value & kPins;
  report_changes();
}

void GpioPort::report_changes() {
  const std::uint32_t now = levels();
  const std::uint32_t changed = now ^ reported_;
  reported_ = now;
  for (std::uint8_t pin = 0; pin < 16 && on_change; ++pin) {
    if ((changed & bit(pin)) != 0) {
      on_change(pin, (now & bit(pin)) != 0);
    }
  }
}

}  // namespace echomap::unicorn
