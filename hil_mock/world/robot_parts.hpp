// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "hil_mock/world/battery.hpp"
#include "hil_mock/world/floor_plan.hpp"
#include "hil_mock/world/ir_range.hpp"
#include "hil_mock/world/mpu6050.hpp"
#include "hil_mock/world/part_params.hpp"
#include "hil_mock/world/robot_body.hpp"
#include "hil_mock/world/scalar_sensor.hpp"
#include "hil_mock/world/wiring.hpp"

namespace echomap::world {

/// The sensors of a robot beside sonar and bumpers, as the pins and the bus of its board see them.
class RobotParts {
 public:
  /// Both must outlive this. The gyro begins at the body's heading.
  RobotParts(const FloorPlan& plan,
             const RobotBody& body,
             const PartParams& params,
             std::uint32_t seed);

  /// Follows the body after it has moved for `dt_s`.
  void step(double dt_s, const WheelDuty& duty);
  /// The body was put elsewhere by hand; the gyro is not told.
  void forget_heading() { heading_rad_ = body_.T_world_robot().heading_rad(); }

  /// Leaves a battery no more than this share of its charge.
  void drain_battery_to(double share);

  /// Whether a part that says yes or no says yes; false for one that is not there.
  bool is_active(PinPart part) const;
  /// Output of a part with a voltage; 0 for one that is not there. The battery's noise is drawn
  /// anew at each call.
  double millivolts(PinPart part);

  /// The gyro on the two-wire bus; null for none.
  Mpu6050* gyro() { return gyro_ ? &*gyro_ : nullptr; }
  const std::optional<Battery>& battery() const { return battery_; }
  /// Pulses of the Geiger tube in the last step.
  std::vector<LowPulse> pulses() const {
    return scalar_ ? scalar_->pulses() : std::vector<LowPulse>();
  }

 private:
  bool sees_cliff(CliffPlace place) const;

  const FloorPlan& plan_;
  const RobotBody& body_;
  PartParams params_;
  std::vector<IrRange> ranges_;
  std::optional<Mpu6050> gyro_;
  std::optional<Battery> battery_;
  std::optional<ScalarSensor> scalar_;
  double heading_rad_;
};

}  // namespace echomap::world
