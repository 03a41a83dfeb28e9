// SPDX-License-Identifier: MIT
#include "host/robot_link/robot_counters.hpp"

#include <algorithm>

#include "protocol/handshake_messages.hpp"

namespace echomap::robot_link {
namespace {

std::uint16_t increase(std::uint16_t from, std::uint16_t to) {
  return static_cast<std::uint16_t>(to - from);
}

}  // namespace

void RobotCounters::take(const protocol::Health& health) {
  frames_bad_ += increase(last_.frames_bad, health.frames_bad);
  frames_lost_ += increase(last_.frames_lost, health.frames_lost);
  receive_overruns_ += increase(last_.receive_overruns, health.receive_overruns);
  telemetry_dropped_ += increase(last_.telemetry_dropped, health.telemetry_dropped);
  encoder_errors_ += increase(last_.encoder_errors, health.encoder_errors);
  if (health.stack_free_bytes != 0) {
    min_stack_free_bytes_ =
        std::min(min_stack_free_bytes_.value_or(health.stack_free_bytes), health.stack_free_bytes);
  }
  last_ = health;
}

void RobotCounters::take(const protocol::EncoderErrors& errors) {
  left_encoder_errors_ += increase(last_errors_.left, errors.left);
  right_encoder_errors_ += increase(last_errors_.right, errors.right);
  last_errors_ = errors;
}

void RobotCounters::take_capabilities(std::uint32_t capabilities) {
  sees_encoder_errors_ = (capabilities & protocol::kCapabilityBlindEncoders) == 0;
}

void RobotCounters::add_to(LinkStatistics& statistics) const {
  statistics.robot_frames_bad = frames_bad_;
  statistics.robot_frames_lost = frames_lost_;
  statistics.robot_receive_overruns = receive_overruns_;
  statistics.robot_telemetry_dropped = telemetry_dropped_;
  const auto if_seen = [this](std::uint64_t errors) {
    return sees_encoder_errors_ ? std::optional(errors) : std::nullopt;
  };
  statistics.robot_encoder_errors = if_seen(encoder_errors_);
  statistics.robot_left_encoder_errors = if_seen(left_encoder_errors_);
  statistics.robot_right_encoder_errors = if_seen(right_encoder_errors_);
  statistics.robot_stack_free_bytes = min_stack_free_bytes_;
  statistics.robot_rate_step = last_.rate_step;
}

}  // namespace echomap::robot_link
