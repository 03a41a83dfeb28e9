// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "protocol/command_messages.hpp"

namespace echomap {
namespace drivers {

/// A gyro that sums up by itself, in the numbers of an MPU-6050: what it has turned in a period is
/// the sample of a rate. Whole degrees make them coarse, and their sum exact.
class GyroAngle {
 public:
  /// Once a millisecond; does nothing while gyro_period_ms is 0.
  void tick(const protocol::ConfigureSensors& settings);
  /// Starts again where the gyro stands at the next sample.
  void restart() {
    is_known_ = false;
    rest_ = 0;
  }

  /// As GyroMpu6050 has them; an error is a period in which the gyro said nothing.
  int32_t yaw_sum() const { return yaw_sum_; }
  uint16_t samples() const { return samples_; }
  uint16_t errors() const { return errors_; }

 private:
  void sample(const protocol::ConfigureSensors& settings);

  int32_t yaw_sum_ = 0;
  int32_t rest_ = 0;  ///< Of the divisions so far.
  uint16_t samples_ = 0;
  uint16_t errors_ = 0;
  int16_t yaw_deg_ = 0;
  bool is_known_ = false;
  uint8_t age_ms_ = 0;
};

}  // namespace drivers
}  // namespace echomap
