// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>

namespace echomap::time {

/// The robot's own clock: microseconds since its reset, unwrapped to 64 bits. A clock type of its
/// own, so that subtracting robot and host stamps does not compile. It has no now(): a stamp only
/// comes from a message.
struct RobotClock {
  using rep = std::int64_t;
  using period = std::micro;
  using duration = std::chrono::duration<rep, period>;
  using time_point = std::chrono::time_point<RobotClock>;
  static constexpr bool is_steady = true;
};
using RobotTime = RobotClock::time_point;

/// Seconds of that clock, rounded to microseconds, and at most 10^12 of them.
inline RobotTime robot_time(double stamp_s) {
  constexpr double kMaxS = 1e12;
  return RobotTime(RobotClock::duration(std::llround(std::clamp(stamp_s, -kMaxS, kMaxS) * 1e6)));
}

/// Extends the 32-bit microseconds of the wire, which wrap every 71.6 minutes.
class RobotTimeUnwrapper {
 public:
  /// The first stamp after the start or a restart counts from the reset. Later ones may run back by
  /// less than half a wrap (frames out of order), never by more.
  RobotTime unwrap(std::uint32_t stamp_us);
  /// The last stamp that was unwrapped.
  RobotTime last() const { return RobotTime(RobotClock::duration(last_us_)); }
  /// The robot was reset: its clock starts at zero again, ours goes on after the last stamp. Where
  /// it is known how much time has `passed` since that stamp, the next one is so much later, or as
  /// much as it counts itself.
  void restart(RobotClock::duration passed = RobotClock::duration::zero());

 private:
  std::int64_t last_us_ = 0;
  std::int64_t epoch_us_ = 0;
  std::int64_t passed_us_ = 0;  ///< Since the last stamp before the restart.
  bool started_ = false;
};

}  // namespace echomap::time
