// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace boards {

/// Length of an echo pulse from the counter, exact but of 16 bits, and from the clock, whole but
/// late: the number nearest to `by_clock` that is `counted` modulo 2^16.
constexpr uint32_t echo_length_half_us(uint32_t by_clock, uint16_t counted) {
  const int32_t late = static_cast<int16_t>(static_cast<uint16_t>(by_clock - counted));
  const uint32_t nearest = by_clock - static_cast<uint32_t>(late);
  return static_cast<int32_t>(nearest) < 0 ? counted : nearest;
}

}  // namespace boards
}  // namespace echomap
