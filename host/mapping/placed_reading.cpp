// SPDX-License-Identifier: MIT
#include "host/mapping/placed_reading.hpp"

#include <algorithm>
#include <iterator>

namespace echomap::mapping {

PlacedReading moved(const PlacedReading& reading, const geometry::Pose2& T_to_from) {
  return {T_to_from * reading.T_map_robot,
          T_to_from * reading.T_map_sonar,
          reading.range_m,
          reading.has_answered};
}

Scan moved(const Scan& scan, const geometry::Pose2& T_to_from) {
  Scan elsewhere;
  elsewhere.reserve(scan.size());
  for (const PlacedReading& reading : scan) {
    elsewhere.push_back(moved(reading, T_to_from));
  }
  return elsewhere;
}

Scan answered(const Scan& scan) {
  Scan answered;
  std::copy_if(scan.begin(), scan.end(), std::back_inserter(answered), [](const auto& reading) {
    return reading.has_answered;
  });
  return answered;
}

std::optional<Eigen::Vector2d> echo_point_m(const PlacedReading& reading) {
  if (!reading.range_m) {
    return std::nullopt;
  }
  return reading.T_map_sonar * Eigen::Vector2d(*reading.range_m, 0.0);
}

}  // namespace echomap::mapping
