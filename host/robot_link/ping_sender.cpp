// SPDX-License-Identifier: MIT
#include "host/robot_link/ping_sender.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace echomap::robot_link {

namespace {

/// Answers come within these, or a line is too slow to tell the time by.
constexpr std::size_t kMostUnanswered = 16;

/// The multiples of the golden ratio fill 0 .. 1 evenly, however many they are (Weyl 1916).
double spread_of(std::uint32_t token) {
  const double multiple = std::numbers::phi * token;
  return multiple - std::floor(multiple);
}

}  // namespace

PingSender::PingSender(const PingParams& params) : params_(params) {
  const auto zero = PingParams::Duration::zero();
  if (params.period <= zero || params.blurred_period <= zero || params.first_period <= zero ||
      params.spread < zero) {
    throw std::invalid_argument("pings: periods must be positive and the spread not negative");
  }
}

void PingSender::restart(time::HostTime now) {
  unanswered_.clear();
  next_ping_ = now;
  first_phase_end_ = now + params_.first_phase;
}

std::uint32_t PingSender::take(time::HostTime now, std::optional<double> uncertainty_us) {
  const bool is_sharp = uncertainty_us && *uncertainty_us <= params_.sharp_us;
  const auto later_period = is_sharp ? params_.period : params_.blurred_period;
  const auto period = now < first_phase_end_ ? params_.first_period : later_period;
  unanswered_.push_back({++last_token_, now});
  if (unanswered_.size() > kMostUnanswered) {
    unanswered_.pop_front();
  }
  const double late_us = spread_of(last_token_) * static_cast<double>(params_.spread.count());
  next_ping_ = now + period - params_.spread / 2 + PingParams::Duration(std::llround(late_us));
  return last_token_;
}

std::optional<time::HostTime> PingSender::take_answer(std::uint32_t token) {
  const auto sent = std::ranges::find(unanswered_, token, &Sent::token);
  if (sent == unanswered_.end()) {
    return std::nullopt;
  }
  const time::HostTime at = sent->at;
  unanswered_.erase(unanswered_.begin(), sent + 1);
  return at;
}

}  // namespace echomap::robot_link
