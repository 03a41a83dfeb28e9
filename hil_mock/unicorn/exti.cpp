// SPDX-License-Identifier: GPL-2.0-or-later
#include "hil_mock/unicorn/exti.hpp"

namespace echomap::unicorn {
namespace {

constexpr std::uint32_t kMapr = 0x04;
constexpr std::uint32_t kExticr1 = 0x08;
constexpr std::uint32_t kTim2OnA15AndB3 = bit(8);
/// SWJ_CFG: a program writes it and reads nonsense.
constexpr unsigned kDebugPortShift = 24;
constexpr std::uint32_t kDebugPortBits = 7U << kDebugPortShift;
constexpr unsigned kJtag = 0;
constexpr unsigned kJtagWithoutReset = 1;

constexpr std::uint32_t kImr = 0x00;
constexpr std::uint32_t kRtsr = 0x08;
constexpr std::uint32_t kFtsr = 0x0C;
constexpr std::uint32_t kPr = 0x14;
constexpr std::uint32_t kPins10To15 = 0xFC00;
constexpr std::uint8_t kLine = 40;

}  // namespace

bool Afio::tim2_is_on_a15_and_b3() const { return (mapr_ & kTim2OnA15AndB3) != 0; }

std::uint32_t Afio::jtag_pins_of_a() const {
  return debug_port() <= kJtagWithoutReset ? bit(15) : 0;
}

std::uint32_t Afio::jtag_pins_of_b() const {
  if (debug_port() == kJtag) {
    return bit(3) | bit(4);
  }
  return debug_port() == kJtagWithoutReset ? bit(3) : 0;
}

std::uint32_t Afio::read(std::uint32_t offset) {
  if (offset == kMapr) {
    return mapr_ & ~kDebugPortBits;
  }
  const std::uint32_t index = (offset - kExticr1) / 4;
  return index < exticr_.size() ? exticr_[index] : 0;
}

void Afio::write(std::uint32_t offset, std::uint32_t value) {
  const std::uint32_t index = (offset - kExticr1) / 4;
  if (offset == kMapr) {
    set_mapr(value);
  } else if (index < exticr_.size()) {
    exticr_[index] = value;
  }
}

void Afio::reset() {
  set_mapr(0);
  exticr_ = {};
}

unsigned Afio::debug_port() const { return (mapr_ & kDebugPortBits) >> kDebugPortShift; }

void Afio::set_mapr(std::uint32_t value) {
  mapr_ = value;
  if (on_remap) {
    on_remap();
  }
}

void Exti::on_pin(std::uint8_t port, std::uint8_t pin, bool high) {
  if (afio_.listens_to(port, pin) && ((high ? rising_ : falling_) & bit(pin)) != 0) {
    pending_ |= bit(pin);
    update();
  }
}

std::uint32_t Exti::read(std::uint32_t offset) {
  switch (offset) {
    case kImr:
      return mask_;
    case kRtsr:
      return rising_;
    case kFtsr:
      return falling_;
    case kPr:
      return pending_;
    default:
      return 0;
  }
}

void Exti::write(std::uint32_t offset, std::uint32_t value) {
  if (offset == kImr) {
    mask_ = value;
  } else if (offset == kRtsr) {
    rising_ = value;
  } else if (offset == kFtsr) {
    falling_ = value;
  } else if (offset == kPr) {
    pending_ &= ~value;
  }
  update();
}

void Exti::reset() {
  mask_ = rising_ = falling_ = pending_ = 0;
  update();
}

void Exti::update() { nvic_.set_line(kLine, (pending_ & mask_ & kPins10To15) != 0); }

}  // namespace echomap::unicorn
