// SPDX-License-Identifier: MIT
#include "host/robot_link/robot_link_params.hpp"

#include <stdexcept>

namespace echomap::robot_link {

RobotLinkParams radio_link() {
  RobotLinkParams params;
  params.retransmission = radio_retransmission();
  params.keep_alive_ttl = std::chrono::milliseconds(500);
  return params;
}

RobotLinkParams checked(const RobotLinkParams& params) {
  using Duration = RobotLinkParams::Duration;
  const bool holds =
      params.hello_period > Duration::zero() && params.keep_alive_period > Duration::zero() &&
      params.keep_alive_ttl > params.keep_alive_period &&
      params.keep_alive_ttl <= std::chrono::milliseconds(500) &&
      params.lost_after > params.quiet_after && params.diagnose_after > params.hello_period;
  if (!holds) {
    throw std::invalid_argument("robot link: periods do not fit together");
  }
  return params;
}

}  // namespace echomap::robot_link
