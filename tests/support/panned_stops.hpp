// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "host/mapping/placed_reading.hpp"
#include "tests/support/told_snapshot.hpp"

namespace echomap::tests {

/// What a sonar on a pan over the robot's middle reads that turns from right to left in steps of 10
/// degrees: 19 readings, growing by a millimetre each.
inline mapping::Scan half_circle_scan(const geometry::Pose2& T_map_robot, double first_range_m) {
  mapping::Scan scan;
  for (int i = 0; i < 19; ++i) {
    const double pan_rad = std::numbers::pi * (i - 9) / 18.0;
    scan.push_back(
        {T_map_robot, T_map_robot * geometry::Pose2(0.0, 0.0, pan_rad), first_range_m + 0.001 * i});
  }
  return scan;
}

/// A robot that stays at x = 0 for 10 s, drives a metre in 10 s and stays for 10 s; ten poses a
/// second, and a half circle at either stop.
inline pipeline::Snapshot run_of_two_stops() {
  std::vector<pipeline::StampedPose> trajectory;
  for (int i = 0; i <= 300; ++i) {
    const double x_m = i < 100 ? 0.0 : i > 200 ? 1.0 : 0.01 * (i - 100);
    trajectory.push_back(pose_at(0.1 * i, {x_m, 0.0, 0.0}));
  }
  mapping::OccupancyGrid grid;
  for (int x = -10; x < 40; ++x) {
    for (int y = -10; y <= 10; ++y) {
      grid.add({x, y}, x == 39 || y == 10 ? 300 : -300);
    }
  }
  mapping::PointCloudMap points;
  points.add({geometry::Pose2(), geometry::Pose2(), 0.75});
  pipeline::Snapshot snapshot =
      snapshot_of(std::move(grid), std::move(trajectory), std::move(points));
  snapshot.stops = 2;
  snapshot.scans = std::make_shared<const std::vector<mapping::Scan>>(std::vector<mapping::Scan>{
      half_circle_scan({}, 0.5), half_circle_scan({1.0, 0.0, 0.0}, 0.8)});
  return snapshot;
}

}  // namespace echomap::tests
