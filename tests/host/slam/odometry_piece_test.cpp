// SPDX-License-Identifier: MIT
#include "host/slam/odometry_piece.hpp"

#include <gtest/gtest.h>

namespace echomap::slam {
namespace {

OdometryPiece drive() { return {{0.9, 0.2, 0.4}, 1.0, 0.4, 0.5, 0.0, 0.0}; }

TEST(OdometryPiece, IsAsMeasuredWithoutSteadyErrors) {
  const geometry::Pose2 pose = calibrated(drive(), {});
  EXPECT_NEAR(pose.x_m(), 0.9, 1e-12);
  EXPECT_NEAR(pose.heading_rad(), 0.4, 1e-12);
}

TEST(OdometryPiece, TurnsByItsDriftAndGrowsByItsScale) {
  const geometry::Pose2 pose = calibrated(drive(), {{0.1, 0.05, 0.02}});
  EXPECT_NEAR(pose.heading_rad(), 0.4 + 0.1 * 0.4 + 0.05, 1e-12);
  EXPECT_NEAR(pose.position_m().norm(), 1.02 * drive().T_before_after.position_m().norm(), 1e-12);
}

TEST(OdometryPiece, ChangesWithTheCalibrationAsItsDerivativesSay) {
  constexpr double kStep = 1e-6;
  const OdometryCalibration calibration{{0.02, -0.05, 0.03}};
  const geometry::Pose2 pose = calibrated(drive(), calibration);
  const Eigen::Matrix3d by = calibrated_by_calibration(drive(), calibration);
  for (Eigen::Index i = 0; i < 3; ++i) {
    OdometryCalibration other = calibration;
    other.values[i] += kStep;
    const geometry::Pose2 moved = calibrated(drive(), other);
    EXPECT_NEAR(by(0, i), (moved.x_m() - pose.x_m()) / kStep, 1e-5) << i;
    EXPECT_NEAR(by(1, i), (moved.y_m() - pose.y_m()) / kStep, 1e-5) << i;
    EXPECT_NEAR(by(2, i), (moved.heading_rad() - pose.heading_rad()) / kStep, 1e-5) << i;
  }
}

TEST(OdometryPiece, IsTheLessCertainTheLongerItIs) {
  OdometryPiece longer = drive();
  longer.path_m *= 2.0;
  const Eigen::Vector3d near = variances(drive(), {});
  const Eigen::Vector3d far = variances(longer, {});
  EXPECT_LT(near[0], far[0]);
  EXPECT_LT(near[2], far[2]);
}

TEST(OdometryPiece, HardlyCountsWhereOdometryHasJumped) {
  OdometryPiece jump = drive();
  jump.jumped_m = 5.0;
  jump.jumped_rad = 1.0;
  EXPECT_GE(variances(jump, {})[0], 25.0);
  EXPECT_GE(variances(jump, {})[2], 1.0);
}

}  // namespace
}  // namespace echomap::slam
