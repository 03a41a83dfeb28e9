// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "hil_mock/world/floor_plan.hpp"
#include "hil_mock/world/noise.hpp"
#include "hil_mock/world/part_params.hpp"
#include "host/geometry/pose2.hpp"

namespace echomap::world {

/// A pulse on the pin, which is high at rest: seconds since the beginning of the step.
struct LowPulse {
  double fall_s = 0.0;
  double rise_s = 0.0;
};

/// A sensor that says one number: a Geiger tube, whose pulses come by chance at the rate of the
/// field (a Poisson process) and not within its dead time, or a light sensor with a noisy voltage.
class ScalarSensor {
 public:
  /// `plan` must outlive this.
  ScalarSensor(const FloorPlan& plan, const ScalarSensorParams& params, const NoiseStream& noise);

  /// Lets `dt_s` pass with the robot at this pose.
  void step(double dt_s, const geometry::Pose2& T_world_robot);

  /// Of the last step; none of a light sensor.
  const std::vector<LowPulse>& pulses() const { return pulses_; }
  /// Output in the last step; 0 of a Geiger tube.
  double millivolts() const { return millivolts_; }

 private:
  void count(double dt_s);

  const FloorPlan& plan_;
  ScalarSensorParams params_;
  NoiseStream noise_;
  geometry::Pose2 T_world_robot_;
  double rate_or_lux_ = 0.0;  ///< At that pose.
  bool is_known_ = false;
  double until_event_ = 0.0;  ///< Of a Poisson process of rate 1.
  double dead_s_ = 0.0;       ///< For so much longer.
  std::vector<LowPulse> pulses_;
  double millivolts_ = 0.0;
};

}  // namespace echomap::world
