// SPDX-License-Identifier: MIT
#include "host/slam/turn_calibration.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/geometry/angle.hpp"
#include "host/geometry/parameter_validator.hpp"
#include "host/slam/mean_turn.hpp"

namespace echomap::slam {
namespace {

/// Chances of a pair of readings, from what the simulated sonars do: one hears what the other does
/// not, both hear nothing, both hear other things.
constexpr double kOneSilent = 0.1;
constexpr double kBothSilent = 0.7;
constexpr double kOtherThings = 0.05;

constexpr double kImpossible = -std::numeric_limits<double>::infinity();
/// A best fit this near to the end of what is tried may have a better one beyond.
constexpr double kEndRad = 0.1;

/// A reading by the way its axis points, as odometry has it.
struct Look {
  double bearing_rad = 0.0;
  std::optional<double> range_m;
};

/// The readings taken while the body was turned as at one of them.
std::vector<Look> looks_at(double turn_rad,
                           const std::vector<StopReading>& readings,
                           double same_rad) {
  std::vector<Look> looks;
  for (const StopReading& reading : readings) {
    if (std::abs(reading.mark.turn_rad - turn_rad) <= same_rad) {
      looks.push_back(
          {reading.mark.turn_rad + reading.T_robot_sonar.heading_rad(), reading.range_m});
    }
  }
  return looks;
}

double log_likelihood(const std::optional<double>& one_m,
                      const std::optional<double>& other_m,
                      double range_stddev_m) {
  if (!one_m || !other_m) {
    return std::log(one_m || other_m ? kOneSilent : kBothSilent);
  }
  const double stddevs = (*one_m - *other_m) / range_stddev_m;
  return std::log(kOtherThings + (1.0 - kOtherThings) * std::exp(-0.5 * stddevs * stddevs));
}

/// Of the last looks turned by an error, given the first ones; an average over the pairs that there
/// are, times all last looks. Where fewer than half of these have a partner nothing can be said.
double log_likelihood_of(double error_rad,
                         const std::vector<Look>& first,
                         const std::vector<Look>& last,
                         const TurnCalibrationParams& params) {
  double sum = 0.0;
  std::size_t pairs = 0;
  for (const Look& look : last) {
    const auto off_rad = [&](const Look& other) {
      return std::abs(geometry::angle_between(other.bearing_rad, look.bearing_rad + error_rad));
    };
    const auto nearest =
        std::min_element(first.begin(), first.end(), [&](const Look& a, const Look& b) {
          return off_rad(a) < off_rad(b);
        });
    if (off_rad(*nearest) <= params.same_axis_rad) {
      sum += log_likelihood(nearest->range_m, look.range_m, params.range_stddev_m);
      ++pairs;
    }
  }
  return 2 * pairs < last.size() ? kImpossible
                                 : params.pair_weight * sum * static_cast<double>(last.size()) /
                                       static_cast<double>(pairs);
}

}  // namespace

void validate(const TurnCalibrationParams& params) {
  geometry::ParameterValidator("turn calibration")
      .positive("min_turn_rad", params.min_turn_rad)
      .positive("same_rad", params.same_rad)
      .positive("step_rad", params.step_rad)
      .at_least("max_error_rad", params.max_error_rad, params.step_rad)
      .positive("same_axis_rad", params.same_axis_rad)
      .positive("range_stddev_m", params.range_stddev_m)
      .positive("pair_weight", params.pair_weight)
      .at_least("min_readings", params.min_readings, 1)
      .positive("max_stddev_rad", params.max_stddev_rad);
}

std::optional<double> turn_share(const std::vector<StopReading>& readings,
                                 const TurnCalibrationParams& params) {
  if (readings.empty()) {
    return std::nullopt;
  }
  const double turn_rad = readings.back().mark.turn_rad - readings.front().mark.turn_rad;
  const auto first = looks_at(readings.front().mark.turn_rad, readings, params.same_rad);
  const auto last = looks_at(readings.back().mark.turn_rad, readings, params.same_rad);
  if (std::abs(turn_rad) < params.min_turn_rad || first.size() < params.min_readings ||
      last.size() < params.min_readings) {
    return std::nullopt;
  }
  std::vector<double> log_likelihoods;
  const int steps = static_cast<int>(std::lround(params.max_error_rad / params.step_rad));
  for (int step = -steps; step <= steps; ++step) {
    log_likelihoods.push_back(log_likelihood_of(step * params.step_rad, first, last, params));
  }
  const auto best = std::max_element(log_likelihoods.begin(), log_likelihoods.end());
  const double best_rad =
      static_cast<double>(best - log_likelihoods.begin() - steps) * params.step_rad;
  if (*best == kImpossible || std::abs(best_rad) > params.max_error_rad - kEndRad) {
    return std::nullopt;
  }
  const TurnEstimate error = mean_turn(log_likelihoods, params.step_rad);
  return error.stddev_rad > params.max_stddev_rad ? std::nullopt
                                                  : std::optional(error.turn_rad / turn_rad);
}

}  // namespace echomap::slam
