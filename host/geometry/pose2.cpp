// SPDX-License-Identifier: MIT
#include "host/geometry/pose2.hpp"

#include <Eigen/Geometry>

#include "host/geometry/angle.hpp"

namespace echomap::geometry {

Pose2::Pose2(double x_m, double y_m, double heading_rad)
    : position_m_(x_m, y_m), heading_rad_(wrap_angle(heading_rad)) {}

Pose2 Pose2::inverse() const {
  const Eigen::Vector2d position = -(Eigen::Rotation2Dd(-heading_rad_) * position_m_);
  return {position.x(), position.y(), -heading_rad_};
}

Pose2 Pose2::operator*(const Pose2& T_b_c) const {
  const Eigen::Vector2d position = *this * T_b_c.position_m_;
  return {position.x(), position.y(), heading_rad_ + T_b_c.heading_rad_};
}

Eigen::Vector2d Pose2::operator*(const Eigen::Vector2d& point_b_m) const {
  return position_m_ + Eigen::Rotation2Dd(heading_rad_) * point_b_m;
}

}  // namespace echomap::geometry
