// SPDX-License-Identifier: MIT
#include "host/mapping/placed_reading.hpp"

namespace echomap::mapping {

std::optional<Eigen::Vector2d> echo_point_m(const PlacedReading& reading) {
  if (!reading.range_m) {
    return std::nullopt;
  }
  return reading.T_map_sonar * Eigen::Vector2d(*reading.range_m, 0.0);
}

}  // namespace echomap::mapping
