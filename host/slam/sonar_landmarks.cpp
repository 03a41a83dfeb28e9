// SPDX-License-Identifier: MIT
#include "host/slam/sonar_landmarks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/geometry/parameter_validator.hpp"
#include "host/geometry/unit_vector.hpp"

namespace echomap::slam {

namespace {

LandmarkSighting wall_sighting(const HeardFeature& wall,
                               const std::vector<mapping::Echo>& echoes,
                               const SonarLandmarksParams& params) {
  const Eigen::Vector2d own_stddev(params.wall_offset_stddev_m, params.wall_normal_stddev_rad);
  LandmarkSighting sighting;
  sighting.kind = LandmarkKind::kWall;
  sighting.value = wall.feature.value;
  sighting.noise = wall.covariance + Eigen::Matrix2d(own_stddev.cwiseAbs2().asDiagonal());
  sighting.along_from_m = std::numeric_limits<double>::max();
  sighting.along_to_m = std::numeric_limits<double>::lowest();
  for (const std::size_t i : wall.echoes) {
    const double at_m = along_m(wall.feature, echoes[i]);
    sighting.along_from_m = std::min(sighting.along_from_m, at_m);
    sighting.along_to_m = std::max(sighting.along_to_m, at_m);
  }
  return sighting;
}

/// Range and bearing have the covariance of the place, turned to face it.
LandmarkSighting point_sighting(const HeardFeature& point, const SonarLandmarksParams& params) {
  const Eigen::Vector2d& place_m = point.feature.value;
  const double range_m = place_m.norm();
  Eigen::Matrix2d by_place;
  by_place << place_m.transpose() / range_m,
      geometry::perpendicular(place_m).transpose() / (range_m * range_m);
  const Eigen::Matrix2d covariance = point.covariance + params.point_stddev_m *
                                                            params.point_stddev_m *
                                                            Eigen::Matrix2d::Identity();
  LandmarkSighting sighting;
  sighting.value = {range_m, std::atan2(place_m.y(), place_m.x())};
  sighting.noise = by_place * covariance * by_place.transpose();
  return sighting;
}

}  // namespace

void validate(const SonarLandmarksParams& params) {
  validate(params.search);
  geometry::ParameterValidator("sonar landmarks")
      .nonnegative_finite("wall_offset_stddev_m", params.wall_offset_stddev_m)
      .nonnegative_finite("wall_normal_stddev_rad", params.wall_normal_stddev_rad)
      .nonnegative_finite("point_stddev_m", params.point_stddev_m);
}

std::vector<LandmarkSighting> sonar_landmarks(const std::vector<mapping::Echo>& echoes,
                                              const SonarLandmarksParams& params,
                                              std::mt19937& random) {
  std::vector<LandmarkSighting> sightings;
  for (const HeardFeature& heard : find_features(echoes, params.search, random)) {
    const bool is_wall = heard.feature.kind == LandmarkKind::kWall;
    if (is_wall && params.with_walls) {
      sightings.push_back(wall_sighting(heard, echoes, params));
    }
    if (!is_wall && params.with_points) {
      sightings.push_back(point_sighting(heard, params));
    }
  }
  return sightings;
}

}  // namespace echomap::slam
