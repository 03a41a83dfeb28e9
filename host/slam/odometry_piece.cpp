// SPDX-License-Identifier: MIT
#include "host/slam/odometry_piece.hpp"

#include <cmath>
#include <initializer_list>

#include <Eigen/Geometry>

#include "host/geometry/angle.hpp"
#include "host/geometry/square.hpp"

namespace echomap::slam {

namespace {

using geometry::square;

double drift_rad(const OdometryPiece& piece, const OdometryCalibration& calibration) {
  return calibration.turn_share() * piece.turn_rad + calibration.drift_rad_per_m() * piece.path_m;
}

/// The way of the piece without its part of the scale.
Eigen::Vector2d drifted_offset_m(const OdometryPiece& piece,
                                 const OdometryCalibration& calibration) {
  return Eigen::Rotation2Dd(drift_rad(piece, calibration) / 2.0) *
         piece.T_before_after.position_m();
}

}  // namespace

bool OdometryNoise::is_sound() const {
  for (const double sd : {heading_stddev_rad,
                          heading_stddev_rad_per_sqrt_m,
                          heading_stddev_rad_per_sqrt_rad,
                          position_stddev_m,
                          position_stddev_m_per_sqrt_m}) {
    if (!(sd >= 0.0) || !std::isfinite(sd)) {
      return false;
    }
  }
  return heading_stddev_rad > 0.0 && position_stddev_m > 0.0;
}

geometry::Pose2 calibrated(const OdometryPiece& piece, const OdometryCalibration& calibration) {
  const Eigen::Vector2d offset_m =
      (1.0 + calibration.drive_share()) * drifted_offset_m(piece, calibration);
  return {offset_m.x(),
          offset_m.y(),
          piece.T_before_after.heading_rad() + drift_rad(piece, calibration)};
}

Eigen::Matrix3d calibrated_by_calibration(const OdometryPiece& piece,
                                          const OdometryCalibration& calibration) {
  const Eigen::Vector2d drifted_m = drifted_offset_m(piece, calibration);
  const Eigen::Vector2d offset_m = (1.0 + calibration.drive_share()) * drifted_m;
  const Eigen::Vector3d by_drift(-offset_m.y() / 2.0, offset_m.x() / 2.0, 1.0);
  Eigen::Matrix3d by;
  by.col(0) = piece.turn_rad * by_drift;
  by.col(1) = piece.path_m * by_drift;
  by.col(2) << drifted_m, 0.0;
  return by;
}

PieceResidual piece_residual(const geometry::Pose2& T_map_before,
                             const geometry::Pose2& T_map_after,
                             const OdometryPiece& piece,
                             const OdometryCalibration& calibration) {
  const geometry::Pose2 driven = calibrated(piece, calibration);
  const geometry::Pose2 T_before_after = T_map_before.inverse() * T_map_after;
  const Eigen::Matrix2d to_before =
      Eigen::Rotation2Dd(-T_map_before.heading_rad()).toRotationMatrix();
  const Eigen::Vector2d& offset_m = T_before_after.position_m();
  PieceResidual residual;
  residual.value << offset_m - driven.position_m(),
      geometry::angle_between(driven.heading_rad(), T_before_after.heading_rad());
  residual.by_before.setZero();
  residual.by_before.topLeftCorner<2, 2>() = -to_before;
  residual.by_before.col(2) << offset_m.y(), -offset_m.x(), -1.0;
  residual.by_after.setIdentity();
  residual.by_after.topLeftCorner<2, 2>() = to_before;
  residual.by_calibration = -calibrated_by_calibration(piece, calibration);
  return residual;
}

Eigen::Vector3d variances(const OdometryPiece& piece, const OdometryNoise& noise) {
  const double heading = square(noise.heading_stddev_rad) +
                         square(noise.heading_stddev_rad_per_sqrt_m) * piece.path_m +
                         square(noise.heading_stddev_rad_per_sqrt_rad) * piece.turned_rad +
                         square(piece.jumped_rad);
  // A heading that walks at random along the way moves its end aside: a third of the variance.
  const double position = square(noise.position_stddev_m) +
                          square(noise.position_stddev_m_per_sqrt_m) * piece.path_m +
                          heading * square(piece.path_m) / 12.0 + square(piece.jumped_m);
  return {position, position, heading};
}

}  // namespace echomap::slam
