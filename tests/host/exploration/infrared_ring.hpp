// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "host/exploration/infrared_follower.hpp"
#include "host/geometry/angle.hpp"

namespace echomap::exploration {

/// The e-puck's ring: which reading is whose.
constexpr std::size_t kAhead = 0;
constexpr std::size_t kOblique = 1;
constexpr std::size_t kBeside = 2;
constexpr std::size_t kObliqueLeft = 6;
constexpr std::size_t kAheadLeft = 7;

inline InfraredFollowerParams ring_params() {
  InfraredFollowerParams params;
  for (const double bearing_deg : {-17.0, -49.0, -90.0, -150.0, 150.0, 90.0, 49.0, 17.0}) {
    const geometry::Pose2 turned(0.0, 0.0, geometry::radians(bearing_deg));
    params.T_robot_sensor.push_back(turned * geometry::Pose2(0.035, 0.0, 0.0));
  }
  return params;
}

/// A round of readings with these sensors answering.
inline std::vector<std::optional<double>> ranges(const std::map<std::size_t, double>& seen_m) {
  std::vector<std::optional<double>> ranges_m(8);
  for (const auto& [sensor, range_m] : seen_m) {
    ranges_m[sensor] = range_m;
  }
  return ranges_m;
}

}  // namespace echomap::exploration
