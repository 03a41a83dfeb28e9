// SPDX-License-Identifier: MIT
#include "host/localization/pose_gaussian.hpp"

#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "host/geometry/angle.hpp"

namespace echomap::localization {
namespace {

using geometry::Pose2;

/// The pose after a motion that is off by these: first turn, drive, second turn, slip to the left.
Pose2 driven(const Eigen::Vector3d& pose,
             const models::OdometryStep& step,
             const Eigen::Vector4d& off) {
  return Pose2(pose(0), pose(1), pose(2)) * Pose2(0.0, 0.0, step.turn_before_rad + off(0)) *
         Pose2(step.drive_m + off(1), off(3), step.turn_after_rad + off(2));
}

Eigen::Vector3d slope(const Pose2& less, const Pose2& more, double step) {
  const Eigen::Vector2d off_m = more.position_m() - less.position_m();
  return Eigen::Vector3d(off_m.x(),
                         off_m.y(),
                         geometry::angle_between(less.heading_rad(), more.heading_rad())) /
         (2.0 * step);
}

TEST(PositionStddev, IsThatOfTheLongAxisWhereverItPoints) {
  EXPECT_DOUBLE_EQ(position_stddev_m({}), 0.0);
  Eigen::Matrix3d covariance = Eigen::Vector3d(0.09, 0.01, 4.0).asDiagonal();
  for (const double turn_rad : {0.0, 0.7, 2.0}) {
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    turn.topLeftCorner<2, 2>() = Eigen::Rotation2Dd(turn_rad).toRotationMatrix();
    EXPECT_NEAR(position_stddev_m({{}, turn * covariance * turn.transpose()}), 0.3, 1e-12);
  }
}

TEST(MotionJacobians, AreTheNumericOnes) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> spread(-1.5, 1.5);
  constexpr double kStep = 1e-6;
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d pose(spread(random), spread(random), spread(random));
    const Pose2 T_before_after(spread(random), spread(random), spread(random));
    const models::OdometryStep step = models::odometry_step({}, T_before_after);
    const MotionJacobians by = motion_jacobians({pose(0), pose(1), pose(2)}, T_before_after, step);
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d off = kStep * Eigen::Vector3d::Unit(k);
      const Eigen::Vector4d none = Eigen::Vector4d::Zero();
      const auto numeric =
          slope(driven(pose - off, step, none), driven(pose + off, step, none), kStep);
      EXPECT_TRUE(by.jacobian_pose.col(k).isApprox(numeric, 1e-6)) << i << " " << k;
    }
    for (int k = 0; k < 4; ++k) {
      const Eigen::Vector4d off = kStep * Eigen::Vector4d::Unit(k);
      const auto numeric = slope(driven(pose, step, -off), driven(pose, step, off), kStep);
      EXPECT_TRUE(by.by_motion.col(k).isApprox(numeric, 1e-6)) << i << " " << k;
    }
  }
}

TEST(PoseGaussian, MovesAsTheOdometryDoes) {
  const PoseGaussian before{{1.0, 2.0, geometry::radians(90.0)},
                            0.01 * Eigen::Matrix3d::Identity()};
  const Pose2 T_before_after(0.5, 0.0, geometry::radians(10.0));
  const auto step = models::odometry_step({}, T_before_after);
  const PoseGaussian after = moved(before, T_before_after, step, {});
  EXPECT_NEAR(after.T_map_robot.y_m(), 2.5, 1e-12);
  // An uncertain heading becomes an uncertain place to the side.
  EXPECT_NEAR(after.covariance(0, 0), 0.01 + 0.25 * 0.01, 1e-12);
  EXPECT_NEAR(after.covariance(1, 1), 0.01, 1e-12);
}

TEST(PoseGaussian, KnowsWhatIsACovariance) {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
  EXPECT_TRUE(is_covariance(matrix));
  matrix(0, 1) = 0.5;
  EXPECT_FALSE(is_covariance(matrix)) << "not symmetric";
  matrix(1, 0) = 0.5;
  EXPECT_TRUE(is_covariance(matrix));
  matrix(2, 2) = 0.0;
  EXPECT_FALSE(is_covariance(matrix)) << "one number without spread";
  matrix(2, 2) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(is_covariance(matrix));
}

TEST(PoseGaussian, KnowsWhatIsFinite) {
  EXPECT_TRUE(is_finite({1.0, 2.0, 3.0}));
  EXPECT_FALSE(is_finite({std::nan(""), 2.0, 3.0}));
}

}  // namespace
}  // namespace echomap::localization
