// SPDX-License-Identifier: MIT
#include "host/sensors/yaw_integrator.hpp"

#include "host/geometry/parameter_validator.hpp"

namespace echomap::sensors {
namespace {

/// Counts of the gyro's 16 bits at the end of its scale.
constexpr double kFullScaleCounts = 32768.0;

/// What 16 bits of samples tell apart.
constexpr double kMaxSamples = 32768.0;

std::int64_t step(std::uint16_t from, std::uint16_t to) {
  return static_cast<std::int16_t>(static_cast<std::uint16_t>(to - from));
}

}  // namespace

YawIntegrator::YawIntegrator(const GyroParams& params) : params_(params) {
  geometry::ParameterValidator("gyro")
      .positive("full_scale_rad_per_s", params.full_scale_rad_per_s)
      .positive("sample_period_s", params.sample_period_s);
}

Yaw YawIntegrator::update(const protocol::Gyro& message) {
  const auto elapsed_us = static_cast<std::int32_t>(message.stamp_us - last_.stamp_us);
  const bool continues = elapsed_us * 1e-6 < kMaxSamples * params_.sample_period_s;
  if (started_ && continues) {
    sum_ += static_cast<std::int32_t>(static_cast<std::uint32_t>(message.yaw_sum) -
                                      static_cast<std::uint32_t>(last_.yaw_sum));
    samples_ += step(last_.samples, message.samples);
    errors_ += step(last_.errors, message.errors);
  }
  started_ = true;
  last_ = message;
  const double rad_per_count =
      params_.full_scale_rad_per_s / kFullScaleCounts * params_.sample_period_s;
  return {static_cast<double>(sum_) * rad_per_count * (params_.upside_down ? -1.0 : 1.0),
          static_cast<double>(samples_) * params_.sample_period_s,
          static_cast<std::uint64_t>(errors_)};
}

}  // namespace echomap::sensors
