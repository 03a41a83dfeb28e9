// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "hil_mock/world/floor_plan.hpp"
#include "hil_mock/world/ir_range.hpp"
#include "host/localization/observation_model.hpp"
#include "host/sensors/infrared_curve.hpp"

namespace echomap::papers {

/// The eight infra-red sensors of a simulated e-puck and the host's understanding of them.
class EpuckRing {
 public:
  /// `field` must outlive this.
  EpuckRing(const world::FloorPlan& field, std::uint32_t seed);

  /// A reading of each sensor, a tenth of a second after the last ones.
  std::vector<localization::RangeReading> read(const geometry::Pose2& T_world_robot);
  /// Where the sensors are, each as T_robot_sensor.
  std::vector<geometry::Pose2> places() const;

 private:
  sensors::InfraredCurve curve_;
  std::vector<world::IrRange> sensors_;
};

}  // namespace echomap::papers
