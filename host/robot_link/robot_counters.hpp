// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "host/robot_link/link_statistics.hpp"
#include "protocol/telemetry_messages.hpp"

namespace echomap::robot_link {

/// Adds up what the robot counts of itself and tells in Health, beyond its resets and beyond the 16
/// bits of its counters.
class RobotCounters {
 public:
  void take(const protocol::Health& health);
  void take(const protocol::EncoderErrors& errors);
  /// What the board can count at all: bits of protocol::Capability.
  void take_capabilities(std::uint32_t capabilities);
  /// The robot was reset: its counters start at zero, ours go on.
  void restart() {
    last_ = {};
    last_errors_ = {};
  }

  /// Fills in what the robot has told.
  void add_to(LinkStatistics& statistics) const;

 private:
  protocol::Health last_{};
  protocol::EncoderErrors last_errors_{};
  std::uint64_t frames_bad_ = 0;
  std::uint64_t frames_lost_ = 0;
  std::uint64_t receive_overruns_ = 0;
  std::uint64_t telemetry_dropped_ = 0;
  std::uint64_t encoder_errors_ = 0;
  std::uint64_t left_encoder_errors_ = 0;
  std::uint64_t right_encoder_errors_ = 0;
  bool sees_encoder_errors_ = true;
  std::optional<std::uint16_t> min_stack_free_bytes_;
};

}  // namespace echomap::robot_link
