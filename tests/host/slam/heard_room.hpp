// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <random>
#include <vector>

#include "host/geometry/angle.hpp"
#include "host/mapping/echo_feature.hpp"

namespace echomap::slam {

using mapping::Echo;
using mapping::EchoFeature;
using mapping::HearingParams;
using models::LandmarkKind;
/// Of a cone, as of the sonar that hears the rooms below.
inline constexpr double kBeamHalfAngleRad = 0.23;

/// A room of 3 x 2.4 m around the origin, and a leg in it.
inline const std::vector<EchoFeature>& walls_and_leg() {
  static const std::vector<EchoFeature> all{
      {LandmarkKind::kWall, {1.5, 0.0}},
      {LandmarkKind::kWall, {1.2, std::numbers::pi / 2.0}},
      {LandmarkKind::kWall, {1.5, std::numbers::pi}},
      {LandmarkKind::kWall, {1.2, -std::numbers::pi / 2.0}},
      {LandmarkKind::kPoint, {0.7, 0.6}},
  };
  return all;
}

/// The range of the nearest that the cone hears; empty where nothing answers.
inline std::optional<double> heard_m(const Echo& cone, const std::vector<EchoFeature>& features) {
  std::optional<double> nearest_m;
  for (const EchoFeature& feature : features) {
    const auto answer = echo_of(feature, cone, HearingParams{}.max_incidence_rad);
    if (answer && (!nearest_m || answer->range_m < *nearest_m)) {
      nearest_m = answer->range_m;
    }
  }
  return nearest_m;
}

/// A sweep all round from a place, in steps of 6 degrees; a share of the echoes is of nothing that
/// is there.
inline std::vector<Echo> sweep(const Eigen::Vector2d& place_m,
                               const std::vector<EchoFeature>& features,
                               double noise_stddev_m,
                               double outliers,
                               std::mt19937& random) {
  std::normal_distribution<double> noise_m(0.0, noise_stddev_m);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  std::vector<Echo> echoes;
  for (int step = 0; step < 60; ++step) {
    Echo echo{place_m, geometry::radians(6.0 * step), 0.0, kBeamHalfAngleRad};
    const auto range_m = heard_m(echo, features);
    const double ghost_m = 0.2 + 2.5 * share(random);
    const double off_m = noise_stddev_m > 0.0 ? noise_m(random) : 0.0;
    if (share(random) < outliers) {
      echo.range_m = ghost_m;
    } else if (range_m) {
      echo.range_m = *range_m + off_m;
    } else {
      continue;
    }
    echoes.push_back(echo);
  }
  return echoes;
}

}  // namespace echomap::slam
