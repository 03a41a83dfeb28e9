// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "host/geometry/pose2.hpp"
#include "host/localization/heading_filter.hpp"
#include "host/sensors/yaw_integrator.hpp"

namespace echomap::localization {

/// A heading filter for steps of a whole move: of a metre ahead the wheels tell the turn to 1.1
/// degrees; ours, for the slip of a small robot.
inline HeadingFilterParams heading_by_moves() {
  HeadingFilterParams params;
  params.wheel_rad_per_root_m = 0.02;
  return params;
}

/// Dead reckoning of Hennessey et al., section II.C: the way by the wheels, the heading by a Kalman
/// filter of gyro and wheels, a step per motion. Without a gyro the wheels alone.
class GyroOdometry {
 public:
  /// Throws std::invalid_argument as HeadingFilter does.
  explicit GyroOdometry(const HeadingFilterParams& params = heading_by_moves())
      : heading_(params) {}

  /// `T_odom_robot` is where the wheels alone place the robot and `yaw` what the gyro has turned,
  /// both since the session began; the robot stands, or it has turned by less than half a turn more
  /// than its gyro says. Answers the new pose.
  const geometry::Pose2& update(const geometry::Pose2& T_odom_robot,
                                const std::optional<sensors::Yaw>& yaw);

  /// From where the robot started.
  const geometry::Pose2& T_start_robot() const { return T_start_robot_; }

 private:
  HeadingFilter heading_;
  geometry::Pose2 T_odom_last_;
  geometry::Pose2 T_start_robot_;
  std::optional<sensors::Yaw> last_yaw_;
};

}  // namespace echomap::localization
