// SPDX-License-Identifier: MIT
#include "host/sensors/scalar_meter.hpp"

#include <cmath>
#include <utility>

#include "host/geometry/parameter_validator.hpp"

namespace echomap::sensors {
namespace {

constexpr std::int32_t kMaxGapUs = 60'000'000;
constexpr double kLastCount = 1023.0;

}  // namespace

ScalarMeter::ScalarMeter(const ScalarParams& params) : params_(params) {
  geometry::ParameterValidator("scalar")
      .at_least("dead_time_s", params_.dead_time_s, 0.0)
      .at_least("background_per_s", params_.background_per_s.value_or(0.0), 0.0)
      .finite("zero", params_.zero)
      .finite("full_scale", params_.full_scale)
      .positive("full_scale - zero", std::abs(params_.full_scale - params_.zero));
}

std::optional<ScalarReading> ScalarMeter::update(const protocol::Scalar& message) {
  if (!last_) {
    last_ = message;
    return std::nullopt;
  }
  const auto passed_us = static_cast<std::int32_t>(message.stamp_us - last_->stamp_us);
  if (passed_us <= 0) {
    return std::nullopt;
  }
  const protocol::Scalar before = std::exchange(*last_, message);
  if (passed_us >= kMaxGapUs) {
    return std::nullopt;
  }
  const double sum = message.sum - before.sum;
  if (params_.kind == ScalarKind::kPulses) {
    return ScalarReading{sum, 1e-6 * passed_us};
  }
  const auto conversions = static_cast<std::uint16_t>(message.samples - before.samples);
  if (conversions == 0) {
    return std::nullopt;
  }
  const double share = sum / conversions / kLastCount;
  return ScalarReading{params_.zero + share * (params_.full_scale - params_.zero), 0.0};
}

}  // namespace echomap::sensors
