// SPDX-License-Identifier: MIT
#include "host/localization/gyro_odometry.hpp"

#include "host/geometry/angle.hpp"

namespace echomap::localization {

const geometry::Pose2& GyroOdometry::update(const geometry::Pose2& T_odom_robot,
                                            const std::optional<sensors::Yaw>& yaw) {
  const geometry::Pose2 T_last_now = T_odom_last_.inverse() * T_odom_robot;
  const double wheel_turn_rad = T_last_now.heading_rad();
  double turn_rad = wheel_turn_rad;
  if (yaw && last_yaw_ && yaw->measured_s > last_yaw_->measured_s) {
    const double gyro_turn_rad = yaw->yaw_rad - last_yaw_->yaw_rad;
    const double before_rad = heading_.heading_rad();
    heading_.update({yaw->measured_s - last_yaw_->measured_s,
                     gyro_turn_rad,
                     gyro_turn_rad + geometry::angle_between(gyro_turn_rad, wheel_turn_rad),
                     T_last_now.position_m().norm()});
    turn_rad = geometry::angle_between(before_rad, heading_.heading_rad());
  }
  // Half of what the gyro knows better about the turn came before the middle of the way.
  const geometry::Pose2 T_turned(0.0, 0.0, 0.5 * (turn_rad - wheel_turn_rad));
  T_start_robot_ = T_start_robot_ * T_turned * T_last_now * T_turned;
  T_odom_last_ = T_odom_robot;
  last_yaw_ = yaw ? yaw : last_yaw_;
  return T_start_robot_;
}

}  // namespace echomap::localization
