// SPDX-License-Identifier: MIT
#include "host/robot_link/robot_link_params.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace echomap::robot_link {

namespace {

using std::chrono::milliseconds;

/// A quarter of what the smallest board takes (docs/protocol.md).
constexpr double kMaxLeadBytes = 24.0;
/// From here on the first pings leave room for all else.
constexpr int kFastBaud = 57600;
constexpr milliseconds kSlowFirstPeriod(25);

}  // namespace

RobotLinkParams wired_link(int baud) {
  constexpr double kBitsPerByte = 10.0;
  constexpr double kUsbFrameUs = 1000.0;
  const double byte_us = kBitsPerByte * 1e6 / std::max(baud, 1);
  RobotLinkParams params;
  params.clock.phase_step_us = std::min(byte_us, kUsbFrameUs);
  params.ping.max_lead_bytes =
      static_cast<std::size_t>(std::min(std::ceil(kUsbFrameUs / byte_us), kMaxLeadBytes));
  params.ping.sharp_us = 50.0 + 0.5 * params.clock.phase_step_us;
  if (baud < kFastBaud) {
    params.ping.first_period = kSlowFirstPeriod;
  }
  return params;
}

RobotLinkParams radio_link() {
  RobotLinkParams params;
  params.retransmission = radio_retransmission();
  params.keep_alive_ttl = milliseconds(500);
  params.ping.first_period = kSlowFirstPeriod;
  params.ping.max_lead_bytes = 0;
  params.ping.sharp_us = 50.0;
  params.clock.telemetry_waits_at_random = true;
  params.clock.phase_step_us = 0.0;
  return params;
}

RobotLinkParams validated(const RobotLinkParams& params) {
  using Duration = RobotLinkParams::Duration;
  const bool holds =
      params.hello_period > Duration::zero() && params.keep_alive_period > Duration::zero() &&
      params.keep_alive_ttl > params.keep_alive_period &&
      params.keep_alive_ttl <= milliseconds(500) && params.lost_after > params.quiet_after &&
      params.diagnose_after > params.hello_period;
  if (!holds) {
    throw std::invalid_argument("robot link: periods do not fit together");
  }
  return params;
}

}  // namespace echomap::robot_link
