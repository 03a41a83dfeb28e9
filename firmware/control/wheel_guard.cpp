// SPDX-License-Identifier: MIT
#include "firmware/control/wheel_guard.hpp"

#include "firmware/control/fixed_point.hpp"

namespace echomap {
namespace control {

using protocol::MotionOutcome;
namespace {

/// In 16 bits, where -(-32768) has no place in an int of the AVR.
uint16_t magnitude(int16_t value) {
  const uint16_t bits = static_cast<uint16_t>(value);
  return value < 0 ? static_cast<uint16_t>(~bits + 1U) : bits;
}

/// An encoder that stands on an edge goes to and fro by a tick.
constexpr uint16_t kChatterTicks = 1;

/// A limit of 0 is none.
bool reached(uint16_t value, uint16_t limit) { return limit != 0 && value >= limit; }

/// 4 periods are 16 ms: a tick in them is 62.5 ticks/s. From 525 ticks on that takes more than 16
/// bits, which an int has on the AVR.
bool too_fast(uint16_t turned_of_4, uint16_t limit_ticks_per_s) {
  return limit_ticks_per_s != 0 && turned_of_4 * uint32_t{125} >= limit_ticks_per_s * uint32_t{2};
}

}  // namespace

MotionOutcome WheelGuard::classify(const protocol::ConfigureSafety& limits,
                                   const WheelPeriod& now) {
  const uint16_t turned = magnitude(now.turned_ticks);
  const uint16_t turned_of_4 = magnitude(now.turned_ticks_of_4);
  const bool silent = turned_of_4 <= kChatterTicks && magnitude(now.duty) >= kDrivenDuty;
  silent_ms_ = silent ? static_cast<uint16_t>(silent_ms_ + kControlPeriodMs) : uint16_t{0};
  if (now.reference_step == 0 ||
      (turned != 0 && (now.turned_ticks > 0) == (now.reference_step > 0))) {
    against_ticks_ = 0;
  } else {
    against_ticks_ = static_cast<uint16_t>(against_ticks_ + turned);
  }
  if (reached(against_ticks_, limits.runaway_ticks)) {
    return MotionOutcome::kRunaway;
  }
  if (too_fast(turned_of_4, limits.over_speed_ticks_per_s)) {
    return MotionOutcome::kOverSpeed;
  }
  return reached(silent_ms_, limits.stall_ms) ? MotionOutcome::kStalled : MotionOutcome::kNone;
}

}  // namespace control
}  // namespace echomap
