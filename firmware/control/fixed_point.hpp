// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "protocol/limits.hpp"

namespace echomap {
namespace control {

/// Wheels are controlled every kControlPeriodMs. References are counted in 1/4000 tick: a speed of
/// 1 tick/s is then 16 of them per period, so that no conversion divides.
constexpr uint8_t kControlPeriodMs = 4;
constexpr uint8_t kControlHz = 250;
constexpr int16_t kOneTick = 4000;
static_assert(INT32_MAX / kOneTick >= protocol::kMaxMoveTicks, "a move's reference has 31 bits");

/// Speed in ticks/s as way of the reference per period.
constexpr int32_t per_period(int16_t ticks_per_s) { return int32_t{ticks_per_s} * 16; }

/// The inverse of `per_period`; rounds down.
constexpr int16_t ticks_per_second(int32_t step) { return static_cast<int16_t>(step >> 4); }

/// Acceleration in ticks/s2 as change of `per_period` per period; at least the smallest there is.
constexpr int32_t change_per_period(uint16_t ticks_per_s2) {
  return int32_t{1} + static_cast<int32_t>(uint32_t{ticks_per_s2} * 16 / kControlHz);
}

}  // namespace control
}  // namespace echomap
