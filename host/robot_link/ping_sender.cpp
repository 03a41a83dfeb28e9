// SPDX-License-Identifier: MIT
#include "host/robot_link/ping_sender.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace echomap::robot_link {

namespace {

/// Answers come within these, or a line is too slow to tell the time by.
constexpr std::size_t kMaxUnanswered = 16;

/// Multiples of these two fill a square evenly, however many they are (Roberts 2018, R2): the
/// powers -2 and -1 of the plastic number.
constexpr double kPhaseStep = 0.5698402909980532;
constexpr double kLeadStep = 0.7548776662466927;

double share_of(std::uint32_t index, double step) {
  const double multiple = step * index;
  return multiple - std::floor(multiple);
}

/// Two pings share a phase, and the second has a lead.
std::uint32_t pair_of(std::uint32_t token) { return token / 2; }
bool has_lead(std::uint32_t token) { return token % 2 != 0; }

}  // namespace

PingSender::PingSender(const PingParams& params) : params_(params) {
  const auto zero = PingParams::Duration::zero();
  if (params.period <= zero || params.blurred_period <= zero || params.first_period <= zero ||
      params.spread <= zero) {
    throw std::invalid_argument("pings: periods and the spread must be positive");
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
  if (unanswered_.size() > kMaxUnanswered) {
    unanswered_.pop_front();
  }
  next_ping_ =
      at_phase(share_of(pair_of(last_token_ + 1), kPhaseStep), now + period - params_.spread / 2);
  return last_token_;
}

/// The first instant from `earliest` on that lies at this share of the spread on the host's clock.
time::HostTime PingSender::at_phase(double share, time::HostTime earliest) const {
  const std::int64_t spread_us = params_.spread.count();
  const std::int64_t phase_us = std::llround(share * static_cast<double>(spread_us));
  const std::int64_t wait_us =
      ((phase_us - earliest.time_since_epoch().count()) % spread_us + spread_us) % spread_us;
  return earliest + PingParams::Duration(wait_us);
}

std::size_t PingSender::lead_bytes() const {
  const std::uint32_t token = last_token_ + 1;
  const double share = has_lead(token) ? share_of(pair_of(token), kLeadStep) : 0.0;
  return static_cast<std::size_t>(share * static_cast<double>(params_.max_lead_bytes + 1));
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
