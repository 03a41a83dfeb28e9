// SPDX-License-Identifier: MIT
#include "host/mapping/sonar_feature.hpp"

#include <cmath>

#include "host/geometry/unit_vector.hpp"

namespace echomap::mapping {

namespace {

/// A shorter baseline turns a centimetre of range error into more than four degrees of bearing.
constexpr double kLeastBaselineM = 0.15;

Eigen::Vector2d left_of(const Eigen::Vector2d& direction) {
  return {-direction.y(), direction.x()};
}

FeatureView view_of_wall(const Eigen::Vector2d& center_m, const Eigen::Vector2d& wall) {
  const Eigen::Vector2d normal = geometry::unit_vector(wall.x());
  FeatureView view;
  view.bearing_rad = wall.x();
  view.range_m = wall.y() - normal.dot(center_m);
  view.jacobian << 1.0, 0.0, -left_of(normal).dot(center_m), 1.0;
  return view;
}

FeatureView view_of_post(const Eigen::Vector2d& center_m, const Eigen::Vector2d& post_m) {
  const Eigen::Vector2d way_m = post_m - center_m;
  const Eigen::Vector2d direction = way_m.normalized();
  FeatureView view;
  view.bearing_rad = std::atan2(way_m.y(), way_m.x());
  view.range_m = way_m.norm();
  view.jacobian << left_of(direction).transpose() / view.range_m, direction.transpose();
  return view;
}

}  // namespace

FeatureView view_from(const Eigen::Vector2d& center_m, const SonarFeature& feature) {
  return feature.is_wall ? view_of_wall(center_m, feature.parameters)
                         : view_of_post(center_m, feature.parameters);
}

std::vector<SonarFeature> features_through(const Sighting& first, const Sighting& second) {
  const Eigen::Vector2d baseline_m = second.center_m - first.center_m;
  const double length_m = baseline_m.norm();
  if (length_m < kLeastBaselineM) {
    return {};
  }
  const Eigen::Vector2d along = baseline_m / length_m;
  const double first_m = first.surface.range_m;
  const double second_m = second.surface.range_m;
  std::vector<SonarFeature> features;
  const double cosine = (first_m - second_m) / length_m;
  if (std::abs(cosine) <= 1.0) {
    for (const double sign : {1.0, -1.0}) {
      const double normal_rad = std::atan2(along.y(), along.x()) + sign * std::acos(cosine);
      const double offset_m = geometry::unit_vector(normal_rad).dot(first.center_m) + first_m;
      features.push_back({true, {normal_rad, offset_m}});
    }
  }
  const double foot_m =
      (length_m * length_m + first_m * first_m - second_m * second_m) / (2.0 * length_m);
  const double squared_height_m2 = first_m * first_m - foot_m * foot_m;
  if (squared_height_m2 > 0.0) {
    for (const double sign : {1.0, -1.0}) {
      const Eigen::Vector2d height_m = sign * std::sqrt(squared_height_m2) * left_of(along);
      features.push_back({false, first.center_m + foot_m * along + height_m});
    }
  }
  return features;
}

}  // namespace echomap::mapping
