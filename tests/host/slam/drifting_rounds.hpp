// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "host/geometry/angle.hpp"
#include "host/geometry/pose2.hpp"

namespace echomap::slam {

/// Around the origin, in so many steps.
struct Circle {
  double radius_m = 0.0;
  int steps = 0;
};

struct Drive {
  std::vector<geometry::Pose2> T_map_robot;
  std::vector<geometry::Pose2> T_odom_robot;
};

/// With an odometry that turns aside.
inline Drive rounds(const Circle& circle, int count, double drift_rad_per_m) {
  using geometry::Pose2;
  const double turn_rad = geometry::radians(360.0) / circle.steps;
  const double travelled_m = circle.radius_m * turn_rad;
  const Pose2 start(circle.radius_m, 0.0, geometry::radians(90.0));
  Drive drive{{start}, {start}};
  for (int i = 0; i < count * circle.steps; ++i) {
    drive.T_map_robot.push_back(drive.T_map_robot.back() * Pose2(travelled_m, 0.0, turn_rad));
    drive.T_odom_robot.push_back(drive.T_odom_robot.back() *
                                 Pose2(travelled_m, 0.0, turn_rad + drift_rad_per_m * travelled_m));
  }
  return drive;
}

inline double worst_error_m(const std::vector<geometry::Pose2>& poses, const Drive& drive) {
  double worst_m = 0.0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    worst_m = std::max(worst_m, (poses[i].position_m() - drive.T_map_robot[i].position_m()).norm());
  }
  return worst_m;
}

}  // namespace echomap::slam
