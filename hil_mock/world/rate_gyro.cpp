// SPDX-License-Identifier: MIT
#include "hil_mock/world/rate_gyro.hpp"

#include <cmath>
#include <numbers>

#include "host/geometry/angle.hpp"

namespace echomap::world {

RateGyro::RateGyro(const GyroParams& params, const NoiseStream& noise)
    : params_(params),
      noise_(noise),
      bias_deg_per_s_(params.bias_stddev_deg_per_s * noise_.normal()),
      scale_(1.0 + params.scale_stddev * noise_.normal()) {}

void RateGyro::step(double dt_s, double yaw_rad_per_s, double bandwidth_hz) {
  bias_deg_per_s_ += params_.bias_walk_deg_per_s_per_sqrt_s * std::sqrt(dt_s) * noise_.normal();
  // A one-sided density N sampled every dt is white noise of N^2 / (2 dt).
  const double white_deg_per_s =
      params_.noise_deg_per_s_per_sqrt_hz * std::sqrt(0.5 / dt_s) * noise_.normal();
  const double input_deg_per_s =
      scale_ * geometry::degrees(yaw_rad_per_s) + bias_deg_per_s_ + white_deg_per_s;
  const double follow = 1.0 - std::exp(-2.0 * std::numbers::pi * bandwidth_hz * dt_s);
  rate_deg_per_s_ += follow * (input_deg_per_s - rate_deg_per_s_);
}

}  // namespace echomap::world
