// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "host/time/host_time.hpp"

namespace echomap::robot_link {

/// When the host asks for the robot's clock.
struct PingParams {
  using Duration = time::HostClock::duration;
  Duration period = std::chrono::seconds(1);
  /// At first the clock is unknown and every ping counts: 0.5 kB/s for both ways together.
  Duration first_period = std::chrono::milliseconds(50);
  Duration first_phase = std::chrono::seconds(20);
};

/// Numbers pings and remembers when the last one was sent. One is on its way at a time: an answer
/// that comes after the next ping was sent is too late to tell much.
class PingSender {
 public:
  /// Throws std::invalid_argument where a period is not positive.
  explicit PingSender(const PingParams& params);

  /// The link is ready (again): pings are frequent for a while.
  void restart(time::HostTime now);
  bool is_due(time::HostTime now) const { return now >= next_ping_; }
  /// The token of a ping that is sent now, due or not.
  std::uint32_t take(time::HostTime now);
  /// When the ping with this token was sent; empty unless it is the last one, unanswered so far.
  std::optional<time::HostTime> take_answer(std::uint32_t token);

 private:
  PingParams params_;
  std::uint32_t last_token_ = 0;
  std::optional<time::HostTime> sent_at_;
  time::HostTime next_ping_;
  time::HostTime first_phase_end_;
};

}  // namespace echomap::robot_link
