// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <vector>

#include "host/exploration/wall_walk.hpp"
#include "host/geometry/polygon.hpp"

namespace echomap::exploration {

/// Of the iRobot Create.
inline const geometry::Pose2 T_robot_wall_sensor(0.13, -0.10, -1.3089969389957472);

/// A walk along the sides of a room, its corners counter-clockwise, with the right hand to the
/// wall: from the middle of its first side round and on to the middle of the side behind that. The
/// robot is 20 cm from the wall and sees nothing of the last 15 cm before and behind a corner. By
/// odometry it turns by `bend_rad_per_m` too much.
inline std::vector<WallStep> walk_round(const geometry::Polygon& room_m,
                                        double bend_rad_per_m = 0.0) {
  constexpr double kStepM = 0.005;
  constexpr double kFromWallM = 0.20;
  const double range_m = (kFromWallM - 0.10) / std::sin(-T_robot_wall_sensor.heading_rad());
  std::vector<WallStep> steps;
  geometry::Pose2 last;
  double travelled_m = 0.0;
  double turned_rad = 0.0;
  for (std::size_t i = 0; i <= room_m.size() + 1; ++i) {
    const geometry::Segment wall = geometry::side(room_m, i % room_m.size());
    const Eigen::Vector2d ahead = (wall.to_m - wall.from_m).normalized();
    const double length_m = wall.length_m();
    const double from_m = i == 0 ? length_m / 2.0 : 0.15;
    const double to_m = i == room_m.size() + 1 ? length_m / 2.0 : length_m - 0.15;
    for (double at_m = from_m; at_m < to_m; at_m += kStepM) {
      const Eigen::Vector2d place_m =
          wall.from_m + at_m * ahead + kFromWallM * geometry::left_normal(wall);
      const geometry::Pose2 pose(place_m.x(), place_m.y(), std::atan2(ahead.y(), ahead.x()));
      if (steps.empty()) {
        last = pose;
        steps.push_back({pose, {false, false, true, range_m}, 0.0, 0.0});
        continue;
      }
      const geometry::Pose2 T_last_now = last.inverse() * pose;
      last = pose;
      const double rolled_m = T_last_now.position_m().norm();
      travelled_m += rolled_m;
      turned_rad += T_last_now.heading_rad();
      steps.push_back({steps.back().T_map_robot * T_last_now *
                           geometry::Pose2(0.0, 0.0, bend_rad_per_m * rolled_m),
                       {false, false, true, range_m},
                       travelled_m,
                       turned_rad});
    }
  }
  return steps;
}

}  // namespace echomap::exploration
