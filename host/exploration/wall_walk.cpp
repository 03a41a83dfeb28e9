// SPDX-License-Identifier: MIT
#include "host/exploration/wall_walk.hpp"

#include <cmath>

namespace echomap::exploration {

void WallWalk::follow(const geometry::Pose2& T_odom_robot) {
  if (!T_odom_robot_) {
    T_odom_robot_ = T_odom_robot;
    T_map_robot_ = T_odom_robot;
    return;
  }
  const geometry::Pose2 T_last_now = T_odom_robot_->inverse() * T_odom_robot;
  T_odom_robot_ = T_odom_robot;
  const double distance_m = std::copysign(T_last_now.position_m().norm(), T_last_now.x_m());
  const double corrected_m = correction_.corrected_m(distance_m);
  const double scale = distance_m == 0.0 ? 1.0 : corrected_m / distance_m;
  T_map_robot_ =
      T_map_robot_ *
      geometry::Pose2(scale * T_last_now.x_m(), scale * T_last_now.y_m(), T_last_now.heading_rad());
  travelled_m_ += std::abs(corrected_m);
  turned_rad_ += T_last_now.heading_rad();
}

void WallWalk::begin() {
  steps_.clear();
  travelled_m_ = 0.0;
  turned_rad_ = 0.0;
}

const WallStep& WallWalk::add(const WallContact& contact) {
  steps_.push_back({T_map_robot_, contact, travelled_m_, turned_rad_});
  return steps_.back();
}

std::vector<WallPoint> wall_points(const std::vector<WallStep>& steps,
                                   const geometry::Pose2& T_robot_sensor) {
  std::vector<WallPoint> points;
  for (const WallStep& step : steps) {
    if (step.contact.wall_beside && !step.contact.bumped && step.contact.range_m) {
      const geometry::Pose2 T_map_sensor = step.T_map_robot * T_robot_sensor;
      points.push_back({T_map_sensor * Eigen::Vector2d(*step.contact.range_m, 0.0),
                        step.travelled_m,
                        step.T_map_robot.heading_rad()});
    }
  }
  return points;
}

}  // namespace echomap::exploration
