// SPDX-License-Identifier: MIT
#include "firmware/drivers/gyro_angle.hpp"

#include "firmware/hal/yaw_gyro.hpp"

namespace echomap {
namespace drivers {
namespace {

/// An MPU-6050 has 32768 counts for 250 degrees a second, and for twice as much with each range.
constexpr int32_t kFullCounts = 32768;
constexpr int32_t kFullDegPerS = 250;
constexpr int32_t kMsPerS = 1000;

}  // namespace

void GyroAngle::tick(const protocol::ConfigureSensors& settings) {
  if (settings.gyro_period_ms != 0 && ++age_ms_ >= settings.gyro_period_ms) {
    age_ms_ = 0;
    sample(settings);
  }
}

void GyroAngle::sample(const protocol::ConfigureSensors& settings) {
  ++samples_;
  int16_t now_deg = 0;
  if (!hal::read_yaw_deg(now_deg)) {
    ++errors_;
    return;
  }
  if (is_known_) {
    const int32_t turned_deg = static_cast<int16_t>(now_deg - yaw_deg_);
    const int32_t divisor = (kFullDegPerS << settings.gyro_range) * settings.gyro_period_ms;
    const int64_t counts = int64_t{turned_deg} * kFullCounts * kMsPerS + rest_;
    rest_ = static_cast<int32_t>(counts % divisor);
    yaw_sum_ = static_cast<int32_t>(static_cast<uint32_t>(yaw_sum_) +
                                    static_cast<uint32_t>(counts / divisor));
  }
  yaw_deg_ = now_deg;
  is_known_ = true;
}

}  // namespace drivers
}  // namespace echomap
