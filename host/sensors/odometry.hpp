// SPDX-License-Identifier: MIT
#pragma once

#include "host/geometry/pose2.hpp"
#include "host/sensors/observations.hpp"

namespace echomap::sensors {

/// Where a robot is after it has rolled `arc_m` while it turned by `turn_rad` at an even rate, seen
/// from where it was: an arc of a circle, exactly (Thrun, Burgard and Fox 2005, equation 5.9).
geometry::Pose2 arc_step(double arc_m, double turn_rad);

/// Dead reckoning of a differential drive: wheel travel in, pose in the odometry frame out. The
/// odometry frame is the robot's pose at the start of the session. Between two updates both wheels
/// are taken to roll at constant speed, so that the update is an `arc_step` (Siegwart and
/// Nourbakhsh 2004, section 5.2.4).
class WheelOdometry {
 public:
  /// Throws std::invalid_argument unless `track_m`, the distance between the wheels, is positive.
  explicit WheelOdometry(double track_m);

  /// Takes the travel since the session began; answers the new pose. A travel that runs back, as of
  /// a late message, takes the pose back.
  const geometry::Pose2& update(const WheelTravel& travel);

  /// The robot was carried there; its wheels go on from `travel`.
  void move_to(const geometry::Pose2& T_odom_robot, const WheelTravel& travel);

  const geometry::Pose2& T_odom_robot() const { return T_odom_robot_; }

 private:
  double track_m_;
  WheelTravel last_;
  geometry::Pose2 T_odom_robot_;
};

}  // namespace echomap::sensors
