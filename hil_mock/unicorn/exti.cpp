// SPDX-License-Identifier: GPL-2.0-or-later
#include "hil_mock/unicorn/exti.hpp"

namespace echomap::unicorn {
namespace {

constexpr std::uint32_t kMapr = 0x04;
constexpr std::uint32_t kExticr1 = 0x08;

constexpr std::uint32_t kImr = 0x00;
constexpr std::uint32_t kRtsr = 0x08;
constexpr std::uint32_t kFtsr = 0x0C;
constexpr std::uint32_t kPr = 0x14;
constexpr std::uint32_t kPins10To15 = 0xFC00;
constexpr std::uint8_t kLine = 40;

}  // namespace

std::uint32_t Afio::read(std::uint32_t offset) {
  if (offset == kMapr) {
    return mapr_;
  }
  const std::uint32_t index = (offset - kExticr1) / 4;
  return index < exticr_.size() ? exticr_[index] : 0;
}

void Afio::write(std::uint32_t offset, std::uint32_t value) {
  const std::uint32_t index = (offset - kExticr1) / 4;
  if (offset == kMapr) {
    mapr_ = value;
  } else if (index < exticr_.size()) {
    exticr_[index] = value;
  }
}

void Afio::reset() {
  mapr_ = 0;
  exticr_ = {};
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
