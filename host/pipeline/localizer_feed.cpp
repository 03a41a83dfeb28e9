// SPDX-License-Identifier: MIT
#include "host/pipeline/localizer_feed.hpp"

#include <algorithm>
#include <cmath>

#include "host/geometry/angle.hpp"

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

std::vector<localization::RangeReading> picked_at_bearings(
    std::span<const localization::RangeReading> gathered,
    const geometry::Pose2& T_odom_robot,
    std::span<const double> bearings_rad) {
  const std::vector<localization::RangeReading> seen =
      evenly_picked(gathered, T_odom_robot, gathered.size());
  constexpr double kMaxOffRad = 0.1;  // A step of a sweep of 6 degrees.
  std::vector<localization::RangeReading> readings;
  for (const double bearing_rad : bearings_rad) {
    const auto off_rad = [&](const localization::RangeReading& reading) {
      return std::abs(geometry::angle_between(bearing_rad, reading.T_robot_sensor.heading_rad()));
    };
    const auto nearest = std::ranges::min_element(seen, {}, off_rad);
    if (nearest != seen.end() && off_rad(*nearest) <= kMaxOffRad) {
      readings.push_back(*nearest);
    }
  }
  return readings;
}

}  // namespace echomap::pipeline
