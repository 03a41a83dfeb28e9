// SPDX-License-Identifier: GPL-2.0-or-later
#include "hil_mock/unicorn/exti.hpp"

namespace echomap::unicorn {
namespace {

constexpr std::uint32_t kImr = 0x00;
constexpr std::uint32_t kRtsr = 0x08;
constexpr std::uint32_t kFtsr = 0x0C;
constexpr std::uint32_t kPr = 0x14;
constexpr std::uint32_t kPins = 0xFFFF;
/// RM0008, table 63: lines 0 to 4 have an interrupt each, 5 to 9 and 10 to 15 have one together.
constexpr std::uint8_t kInterruptOfLine0 = 6;
constexpr std::uint8_t kInterruptOfLines5To9 = 23;
constexpr std::uint8_t kInterruptOfLines10To15 = 40;
constexpr std::uint32_t kLines5To9 = 0x03E0;
constexpr std::uint32_t kLines10To15 = 0xFC00;

}  // namespace

void Exti::take_edge(std::uint8_t line, bool high) {
  pending_ |= bit(line) & (high ? rising_ : falling_);
  tell_nvic();
}

std::uint32_t Exti::read(std::uint32_t offset) {
  switch (offset) {
    case kImr:
      return enabled_;
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
    enabled_ = value & kPins;
  } else if (offset == kRtsr) {
    rising_ = value & kPins;
  } else if (offset == kFtsr) {
    falling_ = value & kPins;
  } else if (offset == kPr) {
    pending_ &= ~value;
  }
  tell_nvic();
}

void Exti::reset() {
  enabled_ = rising_ = falling_ = pending_ = 0;
  tell_nvic();
}

void Exti::tell_nvic() {
  const std::uint32_t active = pending_ & enabled_;
  for (std::uint8_t line = 0; line < 5; ++line) {
    nvic_.set_line(static_cast<std::uint8_t>(kInterruptOfLine0 + line), (active & bit(line)) != 0);
  }
  nvic_.set_line(kInterruptOfLines5To9, (active & kLines5To9) != 0);
  nvic_.set_line(kInterruptOfLines10To15, (active & kLines10To15) != 0);
}

}  // namespace echomap::unicorn
