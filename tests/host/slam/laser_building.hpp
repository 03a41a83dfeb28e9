// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <random>
#include <vector>

#include "host/geometry/angle.hpp"
#include "host/geometry/segment.hpp"
#include "host/geometry/unit_vector.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::tests {

/// Walls that a laser sees.
class LaserBuilding {
 public:
  explicit LaserBuilding(std::vector<geometry::Segment> walls_m) : walls_m_(std::move(walls_m)) {}

  /// 12 m by 8 m with a recess, a pillar and a slanted wall: no two places look alike.
  static LaserBuilding hall() {
    return LaserBuilding({{{0.0, 0.0}, {12.0, 0.0}},
                          {{12.0, 0.0}, {12.0, 8.0}},
                          {{12.0, 8.0}, {7.0, 8.0}},
                          {{7.0, 8.0}, {6.0, 6.5}},
                          {{6.0, 6.5}, {4.0, 6.5}},
                          {{4.0, 6.5}, {4.0, 8.0}},
                          {{4.0, 8.0}, {0.0, 8.0}},
                          {{0.0, 8.0}, {0.0, 0.0}},
                          {{8.0, 3.0}, {8.6, 3.0}},
                          {{8.6, 3.0}, {8.6, 3.6}},
                          {{8.6, 3.6}, {8.0, 3.6}},
                          {{8.0, 3.6}, {8.0, 3.0}}});
  }

  /// 4 m by 4 m with a box in it and a niche.
  static LaserBuilding room() {
    return LaserBuilding({{{0.0, 0.0}, {4.0, 0.0}},
                          {{4.0, 0.0}, {4.0, 4.0}},
                          {{4.0, 4.0}, {0.0, 4.0}},
                          {{0.0, 4.0}, {0.0, 0.0}},
                          {{1.7, 2.0}, {2.2, 2.0}},
                          {{2.2, 2.0}, {2.2, 2.4}},
                          {{0.0, 1.0}, {0.4, 1.0}}});
  }

  /// Corridors, 2 m wide, around a block of 12 m by 8 m: a loop of about 48 m. Niches tell places
  /// apart.
  static LaserBuilding ring() {
    return LaserBuilding({{{0.0, 0.0}, {16.0, 0.0}},
                          {{16.0, 0.0}, {16.0, 12.0}},
                          {{16.0, 12.0}, {0.0, 12.0}},
                          {{0.0, 12.0}, {0.0, 0.0}},
                          {{2.0, 2.0}, {14.0, 2.0}},
                          {{14.0, 2.0}, {14.0, 10.0}},
                          {{14.0, 10.0}, {2.0, 10.0}},
                          {{2.0, 10.0}, {2.0, 2.0}},
                          {{4.0, 0.0}, {4.0, 0.4}},
                          {{9.0, 2.0}, {9.0, 1.7}},
                          {{16.0, 3.5}, {15.6, 3.5}},
                          {{14.0, 7.0}, {14.4, 7.0}},
                          {{12.0, 12.0}, {12.0, 11.7}},
                          {{6.5, 10.0}, {6.5, 10.4}},
                          {{0.0, 8.0}, {0.3, 8.0}},
                          {{2.0, 4.5}, {1.6, 4.5}}});
  }

  /// Two walls without end.
  static LaserBuilding corridor() {
    return LaserBuilding({{{-500.0, -1.0}, {500.0, -1.0}}, {{-500.0, 1.0}, {500.0, 1.0}}});
  }

  /// What `beams` over the half circle ahead measure, with 1 cm of noise, as far as 8 m.
  sensors::RangeScan scan(const geometry::Pose2& T_world_robot,
                          int beams,
                          std::mt19937& random) const {
    std::normal_distribution<double> noise_m(0.0, 0.01);
    sensors::RangeScan scan;
    scan.max_range_m = 8.0;
    for (int i = 0; i < beams; ++i) {
      const double bearing_rad = geometry::radians(180.0 * (i + 0.5) / beams - 90.0);
      const auto direction = geometry::unit_vector(T_world_robot.heading_rad() + bearing_rad);
      std::optional<double> nearest_m;
      for (const geometry::Segment& wall : walls_m_) {
        const auto range_m = geometry::ray_distance_m(T_world_robot.position_m(), direction, wall);
        if (range_m && *range_m < nearest_m.value_or(scan.max_range_m)) {
          nearest_m = range_m;
        }
      }
      if (nearest_m) {
        *nearest_m += noise_m(random);
      }
      scan.beams.push_back({bearing_rad, nearest_m});
    }
    return scan;
  }

 private:
  std::vector<geometry::Segment> walls_m_;
};

}  // namespace echomap::tests
