// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

namespace echomap::robot_link {

/// Counters of a session, both directions.
struct LinkStatistics {
  std::uint64_t bytes_received = 0;
  std::uint64_t frames_received = 0;
  std::uint64_t frames_bad = 0;   ///< Robot to host, failed a check.
  std::uint64_t frames_lost = 0;  ///< Robot to host, missing sequence numbers, bad ones included.
  std::uint64_t frames_foreign =
      0;  ///< Robot to host, whole, of messages this host reads otherwise.
  std::uint64_t frames_sent = 0;
  std::uint64_t frames_withheld = 0;  ///< Not sent: the robot would read them otherwise.
  std::uint64_t commands_resent = 0;
  std::uint64_t resets_seen = 0;
  /// Set-points that a newer one replaced, or that grew too old, before there was credit for them.
  std::uint64_t setpoints_dropped = 0;
  std::uint64_t credit_waits = 0;           ///< Looks at a frame that had to wait for credit.
  std::uint64_t credit_released_bytes = 0;  ///< Sent, and given up for want of an answer.

  /// How often a ready link was so no more, by silence or by a reset, and for how long in all. What
  /// was lost meanwhile is not in `frames_lost`, which knows a gap modulo 256 only.
  std::uint64_t outages = 0;
  std::chrono::microseconds outage_time{};

  /// As the robot has said in Health, of all its starts that the session saw.
  std::uint64_t robot_frames_bad = 0;
  std::uint64_t robot_frames_lost = 0;
  std::uint64_t robot_receive_overruns = 0;
  std::uint64_t robot_telemetry_dropped = 0;
  /// Illegal transitions of the encoders; empty where the board cannot see them.
  std::optional<std::uint64_t> robot_encoder_errors = 0;
  /// Those of each wheel; 0 where the robot does not tell, as before protocol 1.3.
  std::optional<std::uint64_t> robot_left_encoder_errors = 0;
  std::optional<std::uint64_t> robot_right_encoder_errors = 0;
  /// The least it told; empty where it told none.
  std::optional<std::uint16_t> robot_stack_free_bytes;
  std::uint8_t robot_rate_step = 0;  ///< The last: telemetry periods are stretched by 2 to it.

  /// Command to acknowledgement, smoothed as in RFC 6298; empty before the first.
  std::optional<std::chrono::microseconds> round_trip;
};

}  // namespace echomap::robot_link
