// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "protocol/telemetry_messages.hpp"

namespace echomap::sensors {

/// How the gyro is set and mounted.
struct GyroParams {
  /// Rate at the end of its scale: 250, 500, 1000 or 2000 degrees a second of an MPU-6050.
  double full_scale_rad_per_s = 0.0;
  double sample_period_s = 0.0;
  bool upside_down = false;
};

/// What a gyro has turned, through wraps and resets of the robot.
struct Yaw {
  double yaw_rad = 0.0;      ///< Counter-clockwise, its bias included.
  double measured_s = 0.0;   ///< Time that was measured; the bias grows with it.
  std::uint64_t errors = 0;  ///< Samples that the last good one stood in for.
};

/// Turns the gyro's cumulative sums into angles, since the session began.
class YawIntegrator {
 public:
  /// Throws std::invalid_argument unless scale and period are positive.
  explicit YawIntegrator(const GyroParams& params);

  /// Takes messages in any order; between two the robot turns by less than half of what 32 bits
  /// hold. After a gap of 2^15 samples or more the sums go on from here: what was measured in it
  /// cannot be told, and a robot that was not heard for so long has stood.
  Yaw update(const protocol::Gyro& message);
  /// The robot was reset: its sums start at zero, ours go on.
  void restart() { last_ = {}; }

 private:
  GyroParams params_;
  protocol::Gyro last_{};
  bool started_ = false;
  std::int64_t sum_ = 0;
  std::int64_t samples_ = 0;
  std::int64_t errors_ = 0;
};

}  // namespace echomap::sensors
