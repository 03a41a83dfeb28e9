// SPDX-License-Identifier: MIT
#include "host/robot_link/ping_sender.hpp"

#include <stdexcept>
#include <utility>

namespace echomap::robot_link {

PingSender::PingSender(const PingParams& params) : params_(params) {
  if (params.period <= PingParams::Duration::zero() ||
      params.first_period <= PingParams::Duration::zero()) {
    throw std::invalid_argument("pings: a period must be positive");
  }
}

void PingSender::restart(time::HostTime now) {
  sent_at_.reset();
  next_ping_ = now;
  first_phase_end_ = now + params_.first_phase;
}

std::uint32_t PingSender::take(time::HostTime now) {
  next_ping_ = now + (now < first_phase_end_ ? params_.first_period : params_.period);
  sent_at_ = now;
  return ++last_token_;
}

std::optional<time::HostTime> PingSender::take_answer(std::uint32_t token) {
  return token == last_token_ ? std::exchange(sent_at_, std::nullopt) : std::nullopt;
}

}  // namespace echomap::robot_link
