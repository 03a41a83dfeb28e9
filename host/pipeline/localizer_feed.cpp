// SPDX-License-Identifier: MIT
#include "host/pipeline/localizer_feed.hpp"

#include <algorithm>
#include <cmath>

namespace echomap::pipeline {

bool has_moved(const geometry::Pose2& T_odom_before,
               const geometry::Pose2& T_odom_now,
               double step_m,
               double step_rad) {
  const geometry::Pose2 step = T_odom_before.inverse() * T_odom_now;
  return step.position_m().norm() >= step_m || std::abs(step.heading_rad()) >= step_rad;
}

std::vector<localization::RangeReading> evenly_picked(
    std::span<const localization::RangeReading> gathered,
    const geometry::Pose2& T_odom_robot,
    std::size_t most) {
  const geometry::Pose2 T_robot_odom = T_odom_robot.inverse();
  const std::size_t count = std::min(gathered.size(), most);
  std::vector<localization::RangeReading> readings;
  for (std::size_t i = 0; i < count; ++i) {
    const localization::RangeReading& reading = gathered[i * gathered.size() / count];
    readings.push_back({T_robot_odom * reading.T_robot_sensor, reading.range_m});
  }
  return readings;
}

}  // namespace echomap::pipeline
