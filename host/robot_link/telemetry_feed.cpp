// SPDX-License-Identifier: MIT
#include "host/robot_link/telemetry_feed.hpp"

#include <chrono>

namespace echomap::robot_link {

bool TelemetryFeed::continues(std::uint32_t stamp_us) {
  const std::chrono::microseconds step(
      newest_stamp_us_ ? static_cast<std::int32_t>(stamp_us - *newest_stamp_us_) : 0);
  if (step < -max_step_back_) {
    return false;
  }
  if (!newest_stamp_us_ || step.count() > 0) {
    newest_stamp_us_ = stamp_us;
  }
  return true;
}

void TelemetryFeed::deliver(const protocol::Health& message) {
  counters_.take(message);
  listener_.on_health(message);
}

void TelemetryFeed::deliver(const protocol::EncoderErrors& message) {
  counters_.take(message);
  listener_.on_encoder_errors(message);
}

}  // namespace echomap::robot_link
