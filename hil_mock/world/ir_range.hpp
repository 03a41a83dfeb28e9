// SPDX-License-Identifier: MIT
#pragma once

#include "hil_mock/world/floor_plan.hpp"
#include "hil_mock/world/noise.hpp"
#include "hil_mock/world/part_params.hpp"
#include "host/geometry/pose2.hpp"

namespace echomap::world {

/// What a surface does to an infra-red sensor's light.
struct IrTarget {
  double range_m = 0.0;
  double reflectance = 0.9;
  /// Between the beam and the surface's normal.
  double incidence_rad = 0.0;
};

/// Mean output of a sensor in front of a surface.
double ir_millivolts(IrKind kind, const IrTarget& target);

/// An infra-red range sensor: a narrow fan of light, a curve from range to voltage, noise, and an
/// output that stands still between two measurements.
class IrRange {
 public:
  /// `plan` must outlive this.
  IrRange(const FloorPlan& plan, const IrRangeParams& params, const NoiseStream& noise)
      : plan_(plan), params_(params), noise_(noise) {}

  /// Lets `dt_s` pass with the robot at this pose.
  void step(double dt_s, const geometry::Pose2& T_world_robot);

  /// Its output, 0 .. 5000.
  double millivolts() const { return millivolts_; }
  const IrRangeParams& params() const { return params_; }

 private:
  double mean_millivolts(const geometry::Pose2& T_world_sensor) const;

  const FloorPlan& plan_;
  IrRangeParams params_;
  NoiseStream noise_;
  double until_next_s_ = 0.0;
  double millivolts_ = 0.0;
};

}  // namespace echomap::world
