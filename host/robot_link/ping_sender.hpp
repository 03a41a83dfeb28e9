// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
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
  double sharp_us = 100.0;
  /// At first every ping counts: 1.8 kB/s for both ways together.
  Duration first_period = std::chrono::milliseconds(15);
  Duration first_phase = std::chrono::seconds(5);
  /// Pings go at phases of this period that are evenly spread, so that their answers meet every
  /// phase of a latency timer (16 ms in FTDI's chips).
  Duration spread = std::chrono::milliseconds(16);
  /// Bytes to the robot go once in a millisecond (USB), so whole milliseconds are all that the host
  /// chooses by its clock. Every second ping comes behind up to this many delimiters, which take
  /// 87 us each at 115200 baud and together one millisecond: its answer meets the phases between.
  std::size_t max_lead_bytes = 12;
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
  /// How many delimiters go before the next ping.
  std::size_t lead_bytes() const;
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

  time::HostTime at_phase(double share, time::HostTime earliest) const;

  PingParams params_;
  std::uint32_t last_token_ = 0;
  std::deque<Sent> unanswered_;
  time::HostTime next_ping_;
  time::HostTime first_phase_end_;
};

}  // namespace echomap::robot_link
