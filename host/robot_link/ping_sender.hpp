// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "host/time/host_time.hpp"

namespace echomap::robot_link {

/// When the host asks for the robot's clock.
struct PingParams {
  using Duration = time::HostClock::duration;
  Duration period = std::chrono::seconds(1);
  /// While the clock is known worse than `sharp_us`: 0.5 kB/s for both ways together.
  Duration blurred_period = std::chrono::milliseconds(50);
  double sharp_us = 50.0;
  /// At first every ping counts: 1 kB/s.
  Duration first_period = std::chrono::milliseconds(25);
  Duration first_phase = std::chrono::seconds(5);
  /// Pings are late by up to this much, evenly spread, so that they meet every phase of a latency
  /// timer (16 ms in FTDI's chips).
  Duration spread = std::chrono::milliseconds(16);
};

/// Numbers pings and remembers when the last ones were sent.
class PingSender {
 public:
  /// Throws std::invalid_argument where a period is not positive or the spread negative.
  explicit PingSender(const PingParams& params);

  /// The link is ready (again): pings are frequent for a while.
  void restart(time::HostTime now);
  bool is_due(time::HostTime now) const { return now >= next_ping_; }
  time::HostTime next_due() const { return next_ping_; }
  /// The token of a ping that is sent now, due or not. `uncertainty_us` is that of the clock so
  /// far; empty where nothing is known.
  std::uint32_t take(time::HostTime now, std::optional<double> uncertainty_us);
  /// When the ping with this token was sent; empty where it is too old to tell, or was answered.
  std::optional<time::HostTime> take_answer(std::uint32_t token);

 private:
  struct Sent {
    std::uint32_t token;
    time::HostTime at;
  };

  PingParams params_;
  std::uint32_t last_token_ = 0;
  std::deque<Sent> unanswered_;
  time::HostTime next_ping_;
  time::HostTime first_phase_end_;
};

}  // namespace echomap::robot_link
