// SPDX-License-Identifier: MIT
#include "host/time/clock_sync.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace echomap::time {
namespace {

/// Steps of the search for the rate: finer than 1e-6 ppm.
constexpr int kRateBits = 36;
/// Of stamps.
constexpr double kResolutionUs = 1.0;
/// Neither direction is left without a say: the estimate of who is better is a rough one.
constexpr double kMinTrust = 0.25;
constexpr double kMaxTrust = 8.0;
/// Times the expected excess, tuned on the delay models (tests/hil_mock/line_faults).
constexpr double kUncertainty = 3.0;
constexpr double kRateUncertainty = 8.0;

ClockSyncParams validated(const ClockSyncParams& params) {
  using Duration = ClockSyncParams::Duration;
  if (params.window <= Duration::zero() || params.fit_period <= Duration::zero() ||
      params.max_rate_error_ppm <= 0.0 || params.phase_step_us < 0.0) {
    throw std::invalid_argument(
        "clock sync: window, period and rate error must be positive, the step not negative");
  }
  return params;
}

template <class Instant>
std::int64_t micros(Instant instant) {
  return instant.time_since_epoch().count();
}

}  // namespace

ClockSync::ClockSync(const ClockSyncParams& params)
    : params_(validated(params)),
      arrivals_(params.window.count()),
      pongs_(params.window.count()),
      sendings_(params.window.count()) {}

void ClockSync::add_telemetry(std::uint32_t stamp_us, HostTime arrived) {
  const RobotTime stamp = unwrapper_.unwrap(stamp_us);
  if (params_.telemetry_waits_at_random) {
    add_arrival(stamp, arrived);
  }
}

void ClockSync::add_ping(HostTime sent, std::uint32_t stamp_us, HostTime answered) {
  const RobotTime stamp = unwrapper_.unwrap(stamp_us);
  sendings_.add({micros(stamp), -micros(sent)});
  pongs_.add({micros(stamp), micros(answered)});
  add_arrival(stamp, answered);
}

void ClockSync::restart() {
  unwrapper_.restart();
  arrivals_.clear();
  pongs_.clear();
  sendings_.clear();
  next_fit_ = {};
  line_.reset();
}

void ClockSync::add_arrival(RobotTime stamp, HostTime arrived) {
  arrivals_.add({micros(stamp), micros(arrived)});
  if (!sendings_.empty() && arrived >= next_fit_) {
    next_fit_ = arrived + params_.fit_period;
    fit();
  }
}

/// The most likely rate. Were all delays exponential, its line would have the least sum of (mean
/// height of arrivals) / (their excess) and the same of pings; that sum is convex in the rate, so
/// bisection finds its least. `trust` is the weight of arrivals; that of pings is 1.
double ClockSync::likely_rate(const LowerHull& arrivals,
                              const LowerHull& sendings,
                              double trust) const {
  const double middle_us = 0.5 * static_cast<double>(arrivals.vertices().front().robot_us +
                                                     arrivals.vertices().back().robot_us);
  double low = 1.0 - params_.max_rate_error_ppm * 1e-6;
  double high = 1.0 + params_.max_rate_error_ppm * 1e-6;
  for (int i = 0; i < kRateBits; ++i) {
    const double rate = 0.5 * (low + high);
    const double slope_us =
        static_cast<double>(sendings.touched_by(-rate).robot_us) - middle_us +
        trust * (middle_us - static_cast<double>(arrivals.touched_by(rate).robot_us));
    (slope_us > 0.0 ? low : high) = rate;
  }
  return 0.5 * (low + high);
}

/// Where telemetry keeps time with the line's transfers it waits nearly as long every time,
/// scatters little and looks better than it is. Pongs come at any time and tell: their lowest lies
/// as much over the lowest there can be as it is likely to, and that of all arrivals lies below it
/// by what one sees.
double ClockSync::arrivals_excess_us(double rate) const {
  const ClockPoint lowest = arrivals_.hull().touched_by(rate);
  const double pongs_over_lowest_us = height_over(lowest, rate, pongs_.hull().touched_by(rate));
  return std::max(arrivals_.expected_excess_us(rate),
                  pongs_.expected_excess_us(rate) - pongs_over_lowest_us);
}

double ClockSync::share_of_arrivals(double rate) const {
  const double ratio =
      sendings_.expected_excess_us(-rate) / std::max(arrivals_excess_us(rate), kResolutionUs);
  return std::clamp(ratio, kMinTrust, kMaxTrust);
}

void ClockSync::fit() {
  const LowerHull arrivals = arrivals_.hull();
  const LowerHull sendings = sendings_.hull();
  const double first_rate = likely_rate(arrivals, sendings, 1.0);
  const double rate = likely_rate(arrivals, sendings, share_of_arrivals(first_rate));
  const ClockPoint& arrival = arrivals.touched_by(rate);
  const ClockPoint& sending = sendings.touched_by(-rate);
  const double from_arrival_us = static_cast<double>(sending.robot_us - arrival.robot_us);
  const double gap_us =
      static_cast<double>(arrival.host_us + sending.host_us) + rate * from_arrival_us;
  const double arrival_excess_us = arrivals_excess_us(rate);
  const double sending_excess_us = sendings_.expected_excess_us(-rate);

  const double excess_us = arrival_excess_us + sending_excess_us;
  const double span_us = static_cast<double>(arrivals.vertices().back().robot_us -
                                             arrivals.vertices().front().robot_us);

  Line line;
  line.robot_us = arrival.robot_us;
  line.rate = rate;
  line.host_us = static_cast<double>(arrival.host_us) - 0.5 * gap_us -
                 0.5 * (arrival_excess_us - sending_excess_us);
  line.uncertainty_us = kUncertainty * excess_us + 0.5 * params_.phase_step_us;
  line.rate_uncertainty = kRateUncertainty * arrival_excess_us * sending_excess_us /
                          std::max(excess_us * span_us, kResolutionUs);
  line.asymmetry_us = 0.5 * gap_us;
  line_ = line;
}

double ClockSync::Line::uncertainty_us_at(RobotTime stamp) const {
  return uncertainty_us +
         rate_uncertainty * std::abs(static_cast<double>(micros(stamp) - robot_us));
}

std::optional<HostEstimate> ClockSync::host_time(std::uint32_t stamp_us) const {
  if (!line_) {
    return std::nullopt;
  }
  const RobotTime stamp = RobotTimeUnwrapper(unwrapper_).unwrap(stamp_us);
  const auto since_us = static_cast<double>(micros(stamp) - line_->robot_us);
  const auto instant_us = std::llround(line_->host_us + line_->rate * since_us);
  return HostEstimate{HostTime(HostClock::duration(instant_us)),
                      line_->uncertainty_us_at(stamp),
                      line_->asymmetry_us};
}

std::optional<double> ClockSync::uncertainty_us() const {
  return line_ ? std::optional(line_->uncertainty_us_at(unwrapper_.last())) : std::nullopt;
}

std::optional<double> ClockSync::rate_error_ppm() const {
  return line_ ? std::optional((1.0 / line_->rate - 1.0) * 1e6) : std::nullopt;
}

}  // namespace echomap::time
