// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace echomap::geometry {

/// Rigid motion of the plane, SE(2). `T_a_b` maps coordinates of frame b into frame a, so that
/// `T_world_robot * p_robot` is a point of the world. x forward, y left, counter-clockwise.
class Pose2 {
 public:
  Pose2() = default;
  Pose2(double x_m, double y_m, double heading_rad);

  double x_m() const { return position_m_.x(); }
  double y_m() const { return position_m_.y(); }
  const Eigen::Vector2d& position_m() const { return position_m_; }
  /// In (-pi, pi].
  double heading_rad() const { return heading_rad_; }

  Pose2 inverse() const;
  Pose2 operator*(const Pose2& T_b_c) const;
  Eigen::Vector2d operator*(const Eigen::Vector2d& point_b_m) const;

 private:
  Eigen::Vector2d position_m_ = Eigen::Vector2d::Zero();
  double heading_rad_ = 0.0;
};

}  // namespace echomap::geometry
