// SPDX-License-Identifier: MIT
#include "firmware/control/proportion.hpp"

namespace echomap {
namespace control {
namespace {

constexpr uint8_t kDigitBits = 12;
constexpr uint16_t kDigitMask = (1U << kDigitBits) - 1;

}  // namespace

void Proportion::start(int32_t part, int32_t whole) {
  const uint32_t divisor = static_cast<uint32_t>(whole);
  const uint32_t first = static_cast<uint32_t>(part) << kDigitBits;
  const uint32_t second = (first % divisor) << kDigitBits;
  high_digit_ = static_cast<uint16_t>(first / divisor);
  low_digit_ = static_cast<uint16_t>(second / divisor);
  carried_ = 0;
}

int32_t Proportion::scale(int32_t step) {
  const uint32_t longer = static_cast<uint32_t>(step);
  const uint32_t scaled = longer * high_digit_ + ((longer * low_digit_) >> kDigitBits) + carried_;
  carried_ = scaled & kDigitMask;
  return static_cast<int32_t>(scaled >> kDigitBits);
}

}  // namespace control
}  // namespace echomap
