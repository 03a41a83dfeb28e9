// SPDX-License-Identifier: MIT
#include "host/paper_report/measured.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

#include <boost/math/distributions/students_t.hpp>
#include <fmt/format.h>

namespace echomap::paper_report {
namespace {

/// The quantile that leaves 2.5 % above it: with its mirror image it encloses 95 %.
constexpr double kUpperQuantile = 0.975;
/// That quantile of the standard normal distribution.
constexpr double kNormalQuantile = 1.959963984540054;

Measured without_runs() {
  const double none = std::numeric_limits<double>::quiet_NaN();
  return {.value = none, .low = none, .high = none, .runs = 0};
}

double t_quantile(std::size_t degrees_of_freedom) {
  return boost::math::quantile(boost::math::students_t(static_cast<double>(degrees_of_freedom)),
                               kUpperQuantile);
}

/// A number with that many decimals; what rounds to zero has no sign.
std::string number_text(double number, int decimals) {
  std::string text = fmt::format("{:.{}f}", number, std::max(decimals, 0));
  const bool is_zero = text.find_first_not_of("-0.") == std::string::npos;
  return is_zero && text.front() == '-' ? text.substr(1) : text;
}

}  // namespace

Measured measured_share(std::size_t successes, std::size_t runs) {
  assert(successes <= runs);
  if (runs == 0) {
    return without_runs();
  }
  const auto n = static_cast<double>(runs);
  const double share = static_cast<double>(successes) / n;
  const double z2 = kNormalQuantile * kNormalQuantile;
  const double center = (share + z2 / (2.0 * n)) / (1.0 + z2 / n);
  const double half_width =
      kNormalQuantile / (1.0 + z2 / n) * std::sqrt(share * (1.0 - share) / n + z2 / (4.0 * n * n));
  // Rounding must not put the share of none or of all outside of its interval.
  return {.value = share,
          .low = std::clamp(center - half_width, 0.0, share),
          .high = std::clamp(center + half_width, share, 1.0),
          .runs = runs};
}

Measured measured_mean(std::span<const double> values) {
  if (values.empty()) {
    return without_runs();
  }
  const auto n = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
  if (values.size() == 1) {
    return {.value = mean, .low = mean, .high = mean, .runs = 1};
  }
  double squares = 0.0;
  for (const double value : values) {
    squares += (value - mean) * (value - mean);
  }
  const double stddev = std::sqrt(squares / (n - 1.0));
  const double half_width = t_quantile(values.size() - 1) * stddev / std::sqrt(n);
  return {
      .value = mean, .low = mean - half_width, .high = mean + half_width, .runs = values.size()};
}

Measured scaled(const Measured& measured, double factor) {
  return {.value = measured.value * factor,
          .low = measured.low * factor,
          .high = measured.high * factor,
          .runs = measured.runs};
}

std::string text_of(const Measured& measured, const std::string& unit, int decimals) {
  return value_text(measured, unit, decimals) + interval_text(measured, decimals);
}

std::string value_text(const Measured& measured, const std::string& unit, int decimals) {
  if (measured.runs == 0) {
    return "no runs";
  }
  const std::string value = number_text(measured.value, decimals);
  return unit.empty() ? value : value + " " + unit;
}

std::string interval_text(const Measured& measured, int decimals) {
  if (measured.runs == 0) {
    return "";
  }
  if (measured.runs == 1) {
    return ", 1 run";
  }
  return fmt::format(" ({} to {}), {} runs",
                     number_text(measured.low, decimals),
                     number_text(measured.high, decimals),
                     measured.runs);
}

}  // namespace echomap::paper_report
