// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "protocol/command_messages.hpp"
#include "protocol/limits.hpp"

namespace echomap {
namespace drivers {

/// The rate about the vertical axis of an MPU-6050 on the two-wire bus, z up, summed up sample by
/// sample. One transfer a period, judged at the end of it: whatever went wrong by then, a held bus
/// included, is given up, counted, and the device is set up anew.
class GyroMpu6050 {
 public:
  static constexpr uint8_t kMaxRange = 3;

  /// False for a gyro_range that the device does not have, and for a period below the shortest.
  static bool accepts(const protocol::ConfigureSensors& settings) {
    return settings.gyro_range <= kMaxRange &&
           (settings.gyro_period_ms == 0 || settings.gyro_period_ms >= protocol::kMinGyroPeriodMs);
  }

  /// Once a millisecond; does nothing while gyro_period_ms is 0.
  void tick(const protocol::ConfigureSensors& settings);
  /// Lets the bus go and sets the device up anew, with new settings. Until it answers it counts as
  /// at rest.
  void restart();

  /// Sum of the raw samples, modulo 2^32; one that the bus did not bring counts as the last good.
  int32_t yaw_sum() const { return yaw_sum_; }
  /// One each period, modulo 2^16.
  uint16_t samples() const { return samples_; }
  /// Those that the bus did not bring, modulo 2^16.
  uint16_t errors() const { return errors_; }

 private:
  /// Takes what the last transfer brought and starts the next.
  void sample(uint8_t range);
  void start_transfer(uint8_t range);

  int32_t yaw_sum_ = 0;
  int16_t rate_ = 0;
  uint16_t samples_ = 0;
  uint16_t errors_ = 0;
  uint8_t step_ = 0;
  uint8_t age_ms_ = 0;
};

}  // namespace drivers
}  // namespace echomap
