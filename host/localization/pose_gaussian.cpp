// SPDX-License-Identifier: MIT
#include "host/localization/pose_gaussian.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "host/geometry/unit_vector.hpp"

namespace echomap::localization {

double position_stddev_m(const PoseGaussian& belief) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes;
  axes.computeDirect(belief.covariance.topLeftCorner<2, 2>(), Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, axes.eigenvalues().maxCoeff()));
}

bool is_covariance(const Eigen::Matrix3d& matrix) {
  return matrix.allFinite() && matrix.isApprox(matrix.transpose(), 1e-9) &&
         matrix.llt().info() == Eigen::Success;
}

bool is_finite(const geometry::Pose2& pose) {
  return pose.position_m().allFinite() && std::isfinite(pose.heading_rad());
}

MotionJacobians motion_jacobians(const geometry::Pose2& T_map_before,
                                 const geometry::Pose2& T_before_after,
                                 const models::OdometryStep& step) {
  const Eigen::Vector2d offset_m =
      (T_map_before * T_before_after).position_m() - T_map_before.position_m();
  const Eigen::Vector2d ahead =
      geometry::unit_vector(T_map_before.heading_rad() + step.turn_before_rad);
  MotionJacobians jacobians;
  jacobians.jacobian_pose(0, 2) = -offset_m.y();
  jacobians.jacobian_pose(1, 2) = offset_m.x();
  jacobians.by_motion << -offset_m.y(), ahead.x(), 0.0, -ahead.y(),  //
      offset_m.x(), ahead.y(), 0.0, ahead.x(),                       //
      1.0, 0.0, 1.0, 0.0;
  return jacobians;
}

PoseGaussian moved(const PoseGaussian& before,
                   const geometry::Pose2& T_before_after,
                   const models::OdometryStep& step,
                   const models::MotionSpread& spread) {
  const MotionJacobians by = motion_jacobians(before.T_map_robot, T_before_after, step);
  const Eigen::Vector4d std_dev(
      spread.turn_before_rad, spread.drive_m, spread.turn_after_rad, spread.side_m);
  const Eigen::Vector4d variance = std_dev.cwiseAbs2();
  return {before.T_map_robot * T_before_after,
          by.jacobian_pose * before.covariance * by.jacobian_pose.transpose() +
              by.by_motion * variance.asDiagonal() * by.by_motion.transpose()};
}

}  // namespace echomap::localization
