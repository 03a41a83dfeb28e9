// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "host/geometry/pose2.hpp"
#include "host/slam/odometry_piece.hpp"

namespace echomap::slam {

/// Odometry without its systematic errors, as far as they are known: each step as calibrated, on
/// top of the steps before.
class CalibratedOdometry {
 public:
  /// From the next step on.
  void calibrate(const OdometryCalibration& calibration) { calibration_ = calibration; }

  /// The next instant, and where the calibrated odometry has the robot then.
  geometry::Pose2 follow(const geometry::Pose2& T_odom_robot);
  /// The same where the robot did not drive there.
  geometry::Pose2 carry(const geometry::Pose2& T_odom_robot);

  /// From where odometry had the robot at the last instant to where this one has it.
  const geometry::Pose2& T_calibrated_odom() const { return T_calibrated_odom_; }

 private:
  std::optional<OdometryCalibration> calibration_;
  geometry::Pose2 T_odom_robot_;
  geometry::Pose2 T_calibrated_odom_;
};

}  // namespace echomap::slam
