// SPDX-License-Identifier: MIT
#include "host/localization/heading_filter.hpp"

#include <cmath>
#include <stdexcept>

#include "host/geometry/angle.hpp"
#include "host/geometry/square.hpp"

namespace echomap::localization {

namespace {

using geometry::square;

}  // namespace

HeadingFilter::HeadingFilter(const HeadingFilterParams& params) : params_(params) {
  for (const double value : {params.start_heading_stddev_rad,
                             params.start_bias_stddev_rad_per_s,
                             params.gyro_rad_per_root_s,
                             params.bias_rad_per_s_per_root_s,
                             params.wheel_turn_share,
                             params.wheel_floor_rad,
                             params.wheel_rad_per_root_m,
                             params.gate}) {
    if (!std::isfinite(value) || value < 0.0) {
      throw std::invalid_argument("heading filter: a setting is not negative, and finite");
    }
  }
  if (params.wheel_floor_rad == 0.0) {
    throw std::invalid_argument("heading filter: wheels are never without an error");
  }
  const Eigen::Vector2d variance(square(params.start_heading_stddev_rad),
                                 square(params.start_bias_stddev_rad_per_s));
  covariance_ = variance.asDiagonal();
}

HeadingOutcome HeadingFilter::update(const HeadingStep& step) {
  if (!std::isfinite(step.duration_s) || !std::isfinite(step.gyro_turn_rad) ||
      !std::isfinite(step.wheel_turn_rad) || !std::isfinite(step.forward_m)) {
    return HeadingOutcome::kNotFinite;
  }
  if (step.duration_s <= 0.0) {
    return HeadingOutcome::kBadTime;
  }
  const double turn_rad = step.gyro_turn_rad - bias_rad_per_s_ * step.duration_s;
  const double gyro_variance = square(params_.gyro_rad_per_root_s) * step.duration_s;
  // The turn is uncertain by the bias and the gyro's noise, and so it is common with both states.
  const double turn_variance = square(step.duration_s) * covariance_(1, 1) + gyro_variance;
  Eigen::Matrix2d by_state;
  by_state << 1.0, -step.duration_s, 0.0, 1.0;
  const Eigen::Vector2d with_turn(turn_variance - step.duration_s * covariance_(0, 1),
                                  -step.duration_s * covariance_(1, 1));
  covariance_ = (by_state * covariance_ * by_state.transpose()).eval();
  covariance_(0, 0) += gyro_variance;
  covariance_(1, 1) += square(params_.bias_rad_per_s_per_root_s) * step.duration_s;
  heading_rad_ = geometry::wrap_angle(heading_rad_ + turn_rad);

  // By the gyro's turn: by the wheels' own, those that report too little would weigh more.
  const double innovation_rad = step.wheel_turn_rad - turn_rad;
  const double wheel_variance = square(params_.wheel_floor_rad) +
                                square(params_.wheel_rad_per_root_m) * std::abs(step.forward_m) +
                                square(params_.wheel_turn_share * turn_rad);
  const double variance = turn_variance + wheel_variance;
  if (square(innovation_rad) > params_.gate * variance) {
    return HeadingOutcome::kWheelsSlipped;
  }
  heading_rad_ = geometry::wrap_angle(heading_rad_ + with_turn(0) * innovation_rad / variance);
  bias_rad_per_s_ += with_turn(1) * innovation_rad / variance;
  covariance_ -= with_turn * with_turn.transpose() / variance;
  return HeadingOutcome::kApplied;
}

}  // namespace echomap::localization
