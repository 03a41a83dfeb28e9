// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <random>

namespace echomap::mqtt {

/// How long to wait between attempts to connect.
struct BackoffParams {
  double first_s = 0.2;   ///< After the first failure, seconds.
  double max_s = 5.0;     ///< Longest wait: a broker that is back is found within this time.
  double factor = 2.0;    ///< Factor from one wait to the next.
  double jitter = 0.5;    ///< Random share of each wait: a fleet does not reconnect at once.
  double steady_s = 5.0;  ///< A connection that lasted longer, seconds, resets the wait.
};

/// Exponential back-off with jitter. Times are the caller's.
class Backoff {
 public:
  using Clock = std::chrono::steady_clock;

  /// Throws std::invalid_argument with the field, its value and its range.
  Backoff(const BackoffParams& params, std::uint32_t seed);

  bool is_due(Clock::time_point now) const { return now >= next_; }
  void note_connected(Clock::time_point now);
  /// An attempt has failed, or a connection has ended.
  void note_failed(Clock::time_point now);
  /// Wait after the last failure.
  Clock::duration wait() const { return wait_; }

 private:
  BackoffParams params_;
  std::mt19937 random_;
  double step_s_;
  Clock::time_point next_ = Clock::time_point::min();
  Clock::time_point connected_ = Clock::time_point::max();
  Clock::duration wait_{};
};

}  // namespace echomap::mqtt
