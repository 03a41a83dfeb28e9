// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>

namespace echomap::time {

/// The host's clock: microseconds since the session began; simulated time in lockstep, a steady
/// clock on a desk. It has no now(): the session that owns the time passes it in.
struct HostClock {
  using rep = std::int64_t;
  using period = std::micro;
  using duration = std::chrono::duration<rep, period>;
  using time_point = std::chrono::time_point<HostClock>;
  static constexpr bool is_steady = true;
};
using HostTime = HostClock::time_point;

}  // namespace echomap::time
