// SPDX-License-Identifier: MIT
#pragma once

#include "host/geometry/pose2.hpp"

namespace echomap::models {

/// What odometry says of a motion: turn, drive straight, turn again (Thrun, Burgard and Fox 2005,
/// table 5.6).
struct OdometryStep {
  double turn_before_rad = 0.0;
  double drive_m = 0.0;  ///< Negative for backwards, so that the first turn is at most 90 degrees.
  double turn_after_rad = 0.0;
};

/// The step from one pose of the odometry to the next. What is driven over less than a millimetre
/// is a turn on the spot.
OdometryStep odometry_step(const geometry::Pose2& T_odom_before,
                           const geometry::Pose2& T_odom_after);

/// Standard deviations of a motion around what odometry says of it.
struct MotionSpread {
  double turn_before_rad = 0.0;
  double drive_m = 0.0;
  double turn_after_rad = 0.0;
  double side_m = 0.0;
};

/// Noise of the odometry by the motion.
struct OdometryMotionParams {
  /// alpha1, alpha2 (Thrun et al. 2005, table 5.6): variance of a turn per squared turn and per
  /// squared drive.
  double alpha1 = 0.0009;              ///< 3 % of the turn.
  double alpha2_rad2_per_m2 = 0.0009;  ///< 1.7 degrees a metre.
  /// alpha3, alpha4: variance of the drive per squared drive and per squared turns.
  double alpha3 = 0.0009;            ///< 3 % of the drive.
  double alpha4_m2_per_rad2 = 1e-4;  ///< 1 cm a radian: wheels that scrub.
  /// Variance sideways per squared drive: wheels that slip. Not in the book.
  double side_slip = 4e-4;
};

/// The odometry model of a differential drive with squares (Thrun et al. 2005, table 5.6).
class OdometryMotion {
 public:
  /// Throws std::invalid_argument for a parameter that is negative or not finite.
  explicit OdometryMotion(const OdometryMotionParams& params = {});

  MotionSpread spread(const OdometryStep& step) const;

 private:
  OdometryMotionParams params_;
};

}  // namespace echomap::models
