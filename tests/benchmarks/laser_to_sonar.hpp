// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <random>
#include <vector>

#include <Eigen/Core>

#include "host/datasets/log_record.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::bench {

/// The pan sonar that a laser scan is heard with.
struct LaserToSonarParams {
  /// Directions of the pan, each in the middle of its share of the laser's field of view; the cones
  /// at the ends hear nothing beyond that field.
  std::size_t directions = 24;
  /// HC-SR04's data sheet: 15 degrees off the axis; Hennessey et al.: 32.8 +- 9.6 across.
  double beam_half_angle_rad = 0.2618;
  double max_range_m = 3.0;
  /// Standard deviation of a range: a share of it (NXT, 1 m: 0.5 cm; hcsr04 notes) beside a fixed
  /// part.
  double noise_m = 0.01;
  double noise_share = 0.005;
  /// Whether walls throw sound aside. Without it the nearest beam of the cone always answers.
  bool specular = true;
  /// Incidence, beam against the wall's normal, beyond which a smooth wall does not answer. With a
  /// cone of 15 degrees it falls silent 30 degrees off the axis (measured: 25 to 30, HC-SR04,
  /// UNIVPM).
  double smooth_limit_rad = 0.2618;
  /// The same for what is rough or small (NXT, Imperial College: garbage from 45 degrees on).
  double rough_limit_rad = 0.8727;
  /// A wall whose points lie on a line to this is smooth: a laser's noise of 1 to 2 cm.
  double smooth_residual_m = 0.02;
  /// Chance that sound which a smooth wall throws aside comes back by a second wall that it meets
  /// within the smooth limit.
  double second_bounce_chance = 0.025;
};

/// What a pan sonar has heard, and where its answers came from.
struct HeardScan {
  sensors::RangeScan scan;
  /// The laser's points that answered, in the laser's frame; of a second bounce the first point.
  std::vector<Eigen::Vector2d> origins_m;
};

/// What a pan sonar in the laser's place would have read: each direction's nearest answer within
/// its cone. Edges, where no normal can be told, answer at any incidence. A laser beam without
/// return is empty space. Throws std::invalid_argument for invalid parameters and for beams that do
/// not go counter-clockwise.
HeardScan heard_scan(const sensors::RangeScan& laser,
                     const LaserToSonarParams& params,
                     std::mt19937& random);

}  // namespace echomap::bench
