// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "host/time/host_time.hpp"

namespace echomap::robot_link {

/// When an unanswered command is sent again.
struct RetransmissionParams {
  using Duration = time::HostClock::duration;
  Duration initial = std::chrono::milliseconds(200);  ///< Before the first round trip is known.
  Duration floor = std::chrono::milliseconds(25);     ///< USB and TCP.
  Duration ceiling =
      std::chrono::milliseconds(400);  ///< So that eight tries end in three and a half seconds.
};

/// For Bluetooth SPP, whose radio holds bytes back for 150 ms now and then.
constexpr RetransmissionParams radio_retransmission() {
  return {.floor = std::chrono::milliseconds(200)};
}

/// The retransmission timeout of RFC 6298, section 2: smoothed round trip plus four deviations,
/// doubled at each resend.
class RetransmissionTimer {
 public:
  using Duration = time::HostClock::duration;

  /// Throws std::invalid_argument unless 0 < floor <= initial <= ceiling.
  explicit RetransmissionTimer(const RetransmissionParams& params);

  /// A round trip of a command that was sent once only (Karn's rule, section 3).
  void sample(Duration round_trip);
  /// A resend was needed (rule 5.5).
  void back_off();

  Duration timeout() const { return timeout_; }
  std::optional<Duration> smoothed_round_trip() const { return smoothed_; }

 private:
  RetransmissionParams params_;
  Duration timeout_;
  std::optional<Duration> smoothed_;
  Duration deviation_{};
};

}  // namespace echomap::robot_link
