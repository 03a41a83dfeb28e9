// SPDX-License-Identifier: MIT
#pragma once

#include "host/geometry/pose2.hpp"
#include "host/models/odometry_motion.hpp"

namespace echomap::models {

/// What a robot was told to do: for one without encoders, all that is known of its motion.
struct VelocityCommand {
  double speed_m_per_s = 0.0;
  double turn_rad_per_s = 0.0;  ///< Counter-clockwise.
  double duration_s = 0.0;
};

/// Standard normal numbers, one for each of the three errors of a motion.
struct VelocityNoise {
  double speed = 0.0;
  double turn = 0.0;
  double final_turn = 0.0;
};

/// alpha1 to alpha6 of Thrun, Burgard and Fox 2005, table 5.3: variances by the squares of speed
/// and turn. Ours, for a motor without feedback, whose speed depends on floor and battery.
struct VelocityMotionParams {
  double speed_by_speed = 0.01;                ///< alpha1: 10 % of the speed.
  double speed_by_turn_m2_per_rad2 = 1e-4;     ///< alpha2.
  double turn_by_speed_rad2_per_m2 = 0.01;     ///< alpha3: 5.7 degrees a metre.
  double turn_by_turn = 0.01;                  ///< alpha4: 10 % of the turn.
  double final_by_speed_rad2_per_m2 = 0.0025;  ///< alpha5.
  double final_by_turn = 0.0025;               ///< alpha6.
};

/// The velocity motion model (Thrun et al. 2005, table 5.3): an arc with noisy speed and turn, and
/// a turn at its end, without which all poses would lie on a surface.
class VelocityMotion {
 public:
  /// Throws std::invalid_argument for a parameter that is negative or not finite.
  explicit VelocityMotion(const VelocityMotionParams& params = {});

  /// The motion, seen from where it began, for one draw of the noise; without, that of the command.
  geometry::Pose2 sample(const VelocityCommand& command, const VelocityNoise& noise = {}) const;

  /// The spread of an arc, however long it took, as a turn, a drive along its chord and a turn: for
  /// a filter that takes poses put together from commands for odometry. Variances of place and
  /// heading are those of `sample`; their covariance is half of it, as both turns err apart.
  MotionSpread spread(const OdometryStep& arc) const;

 private:
  VelocityMotionParams params_;
};

}  // namespace echomap::models
