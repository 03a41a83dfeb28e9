// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "hil_mock/world/motor_driver.hpp"
#include "hil_mock/world/robot_params.hpp"

namespace echomap::world {

/// A change of one encoder's pins. Forward, channel A leads: A B = 00, 10, 11, 01.
struct LevelChange {
  /// Since the beginning of the step.
  double at_s = 0.0;
  bool a = false;
  bool b = false;
};

/// One wheel with its motor and encoder.
class WheelDrive {
 public:
  /// `diameter_m` and `gain` (speed at a given duty, 1 as specified) are the true ones.
  WheelDrive(const DriveParams& params, double diameter_m, double gain);

  /// Applies `drive` for `dt_s`, appends the encoder's changes in order of time and returns how far
  /// the wheel has rolled, in metres.
  double step(double dt_s, const MotorDrive& drive, std::vector<LevelChange>& changes);

  /// From now on the encoder gives so many times the edges of its parameters.
  void scale_counts(double scale) { counts_scale_ = scale; }

  /// Edges that the encoder has given, forward minus backward.
  std::int64_t counts() const { return counts_; }
  /// Speed, as a share of that at full duty.
  double speed_share() const { return counts_per_s_ / no_load_counts_per_s_; }

 private:
  double target_counts_per_s_of(double duty) const;
  void rub(double target_counts_per_s, double max_change_counts_per_s);

  double dead_zone_duty_;
  double time_constant_s_;
  double coast_share_;  ///< Of the braking of a motor with closed windings, when they are open.
  double no_load_counts_per_s_;
  double rubbing_counts_per_s2_;
  double metres_per_count_;
  /// Before they are scaled.
  double counts_per_s_ = 0.0;
  double counts_scale_ = 1.0;
  /// The encoder rests in the middle between two edges.
  double position_counts_ = 0.5;
  std::int64_t counts_ = 0;
};

}  // namespace echomap::world
