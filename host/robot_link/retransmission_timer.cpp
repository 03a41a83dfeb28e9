// SPDX-License-Identifier: MIT
#include "host/robot_link/retransmission_timer.hpp"

#include <algorithm>
#include <stdexcept>

namespace echomap::robot_link {

RetransmissionTimer::RetransmissionTimer(const RetransmissionParams& params)
    : params_(params), timeout_(params.initial) {
  if (params.floor <= Duration::zero() || params.initial < params.floor ||
      params.ceiling < params.initial) {
    throw std::invalid_argument("retransmission: 0 < floor <= initial <= ceiling does not hold");
  }
}

void RetransmissionTimer::sample(Duration round_trip) {
  if (smoothed_) {
    // Rule 2.3 with alpha = 1/8 and beta = 1/4; the deviation first, by the old mean.
    const Duration error = std::chrono::abs(*smoothed_ - round_trip);
    deviation_ = (3 * deviation_ + error) / 4;
    smoothed_ = (7 * *smoothed_ + round_trip) / 8;
  } else {
    smoothed_ = round_trip;
    deviation_ = round_trip / 2;
  }
  timeout_ = std::clamp(*smoothed_ + 4 * deviation_, params_.floor, params_.ceiling);
}

void RetransmissionTimer::back_off() { timeout_ = std::min(2 * timeout_, params_.ceiling); }

}  // namespace echomap::robot_link
