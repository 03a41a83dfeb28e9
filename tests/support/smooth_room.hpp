// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "host/geometry/angle.hpp"
#include "host/mapping/placed_reading.hpp"

namespace echomap::tests {

/// A wall that never ends, a unit normal away from the room and the distance of the origin from it.
struct EndlessWall {
  double normal_rad = 0.0;
  double offset_m = 0.0;
};

inline constexpr double kBeamHalfAngleRad = 0.2269;
/// A smooth wall answers up to this incidence.
inline constexpr double kMirrorRad = 0.262;

/// Smooth walls, and corners that answer from any direction.
struct SmoothRoom {
  std::vector<EndlessWall> walls = {};
  std::vector<Eigen::Vector2d> corners_m = {};
};

/// Four walls, x from -1.1 to 1.3, y from -0.7 to 0.9.
inline SmoothRoom smooth_rectangle() {
  using geometry::radians;
  return {{{radians(0.0), 1.3}, {radians(90.0), 0.9}, {radians(180.0), 1.1}, {radians(-90.0), 0.7}},
          {{1.3, 0.9}, {-1.1, 0.9}, {-1.1, -0.7}, {1.3, -0.7}}};
}

/// The range that a wide, noiseless beam reads: the nearest wall that mirrors it back, or corner.
inline std::optional<double> ideal_range_m(const geometry::Pose2& T_map_sonar,
                                           const SmoothRoom& room) {
  std::optional<double> nearest_m;
  for (const auto& wall : room.walls) {
    const Eigen::Vector2d normal(std::cos(wall.normal_rad), std::sin(wall.normal_rad));
    const double foot_m = wall.offset_m - normal.dot(T_map_sonar.position_m());
    const double incidence_rad =
        std::max(0.0,
                 std::abs(geometry::angle_between(T_map_sonar.heading_rad(), wall.normal_rad)) -
                     kBeamHalfAngleRad);
    if (foot_m > 0.0 && incidence_rad < kMirrorRad) {
      const double range_m = foot_m / std::cos(incidence_rad);
      nearest_m = std::min(nearest_m.value_or(range_m), range_m);
    }
  }
  for (const auto& corner_m : room.corners_m) {
    const Eigen::Vector2d offset_m = T_map_sonar.inverse() * corner_m;
    if (std::abs(std::atan2(offset_m.y(), offset_m.x())) < kBeamHalfAngleRad) {
      nearest_m = std::min(nearest_m.value_or(offset_m.norm()), offset_m.norm());
    }
  }
  return nearest_m;
}

/// 120 readings, twice around in steps of 6 degrees, from one place.
inline mapping::Scan scan_of(const SmoothRoom& room, const Eigen::Vector2d& place_m = {0.0, 0.0}) {
  mapping::Scan scan;
  for (int i = 0; i < 120; ++i) {
    const geometry::Pose2 T_map_sonar(place_m.x(), place_m.y(), geometry::radians(6.0 * i));
    scan.push_back({T_map_sonar, T_map_sonar, ideal_range_m(T_map_sonar, room)});
  }
  return scan;
}

}  // namespace echomap::tests
