// SPDX-License-Identifier: MIT
#include "host/mapping/placed_reading.hpp"

namespace echomap::mapping {

PlacedReading moved(const PlacedReading& reading, const geometry::Pose2& T_to_from) {
  return {T_to_from * reading.T_map_robot, T_to_from * reading.T_map_sonar, reading.range_m};
}

Scan moved(const Scan& scan, const geometry::Pose2& T_to_from) {
  Scan elsewhere;
  elsewhere.reserve(scan.size());
  for (const PlacedReading& reading : scan) {
    elsewhere.push_back(moved(reading, T_to_from));
  }
  return elsewhere;
}

std::optional<Eigen::Vector2d> echo_point_m(const PlacedReading& reading) {
  if (!reading.range_m) {
    return std::nullopt;
  }
  return reading.T_map_sonar * Eigen::Vector2d(*reading.range_m, 0.0);
}

}  // namespace echomap::mapping
