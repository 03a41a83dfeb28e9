// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "host/geometry/pose2.hpp"
#include "host/models/odometry_motion.hpp"

namespace echomap::localization {

/// A normal distribution of poses around one.
struct PoseGaussian {
  geometry::Pose2 T_map_robot;
  /// Of x, y (m) and heading (rad).
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

/// Standard deviation of the position in the direction in which it is the largest, metres.
double position_stddev_m(const PoseGaussian& belief);

/// Whether it is finite, symmetric and positive definite.
bool is_covariance(const Eigen::Matrix3d& matrix);

/// Whether all three numbers of a pose are finite.
bool is_finite(const geometry::Pose2& pose);

/// How the pose after a motion changes: A and W of Mahmood and Ridao 2017, Algorithm 1.
struct MotionJacobians {
  Eigen::Matrix3d jacobian_pose = Eigen::Matrix3d::Identity();
  /// By the first turn, the drive, the second turn and the slip to the left.
  Eigen::Matrix<double, 3, 4> by_motion = Eigen::Matrix<double, 3, 4>::Zero();
};

/// Of the motion from a pose by `T_before_after`, which is driven as `step`.
MotionJacobians motion_jacobians(const geometry::Pose2& T_map_before,
                                 const geometry::Pose2& T_before_after,
                                 const models::OdometryStep& step);

/// The distribution after a motion with that spread (Algorithm 1, lines 2 and 3).
PoseGaussian moved(const PoseGaussian& before,
                   const geometry::Pose2& T_before_after,
                   const models::OdometryStep& step,
                   const models::MotionSpread& spread);

}  // namespace echomap::localization
