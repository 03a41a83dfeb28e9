// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "host/geometry/pose2.hpp"

namespace echomap::slam {

/// What odometry says of the way from one multiscan to the next.
struct OdometryPiece {
  geometry::Pose2 T_before_after;
  double path_m = 0.0;      ///< Driven, forwards or backwards.
  double turn_rad = 0.0;    ///< Turned in all, to the left; not wrapped.
  double turned_rad = 0.0;  ///< Turned, whether to the left or to the right.
  /// Jumps in it, which were hardly driven: odometry was reset, or data are missing.
  double jumped_m = 0.0;
  double jumped_rad = 0.0;
};

/// How odometry is off all the time: wheels of other sizes than believed, or of two sizes, another
/// track. As a vector: share of a turn, drift of the heading in rad/m, share of a drive.
struct OdometryCalibration {
  Eigen::Vector3d values = Eigen::Vector3d::Zero();

  double turn_share() const { return values[0]; }
  double drift_rad_per_m() const { return values[1]; }
  double drive_share() const { return values[2]; }
};

/// How far odometry is off by chance: variances grow with what was driven and turned (a random
/// walk). Those of small robots on smooth floor.
struct OdometryNoise {
  double heading_stddev_rad = 0.003;  ///< Of every piece.
  double heading_stddev_rad_per_sqrt_m = 0.02;
  double heading_stddev_rad_per_sqrt_rad = 0.03;
  double position_stddev_m = 0.005;  ///< Of every piece.
  double position_stddev_m_per_sqrt_m = 0.02;

  bool is_sound() const;
};

/// A piece as it was driven if odometry is off as `calibration` says. Half of the drift comes
/// before the way, half behind it.
geometry::Pose2 calibrated(const OdometryPiece& piece, const OdometryCalibration& calibration);

/// The derivative of x, y and heading of `calibrated` by the calibration's values.
Eigen::Matrix3d calibrated_by_calibration(const OdometryPiece& piece,
                                          const OdometryCalibration& calibration);

/// What is left of the motion between two poses after what odometry measured of it, in the frame of
/// the pose before: x, y and heading. With the derivatives by the pose before and the one after, x,
/// y and heading in the map frame, and by the calibration's values.
struct PieceResidual {
  Eigen::Vector3d value = Eigen::Vector3d::Zero();
  Eigen::Matrix3d by_before = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d by_after = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d by_calibration = Eigen::Matrix3d::Zero();
};

/// The residual of a piece between two poses, for an odometry that is off as `calibration` says.
PieceResidual piece_residual(const geometry::Pose2& T_map_before,
                             const geometry::Pose2& T_map_after,
                             const OdometryPiece& piece,
                             const OdometryCalibration& calibration);

/// Variances along x, y and heading of the piece. A jump may have been anything from no motion at
/// all to twice what odometry says.
Eigen::Vector3d variances(const OdometryPiece& piece, const OdometryNoise& noise);

}  // namespace echomap::slam
