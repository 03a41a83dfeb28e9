// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "host/mapping/sonar_surfaces.hpp"

namespace echomap::mapping {

/// A surface with the place it was seen from.
struct Sighting {
  std::size_t scan = 0;
  std::size_t index = 0;
  Eigen::Vector2d center_m = Eigen::Vector2d::Zero();
  SonarSurface surface;
};

/// What a sonar can see of the world: a straight wall, or a post, which also stands for corners.
struct SonarFeature {
  bool is_wall = true;
  /// A wall: bearing of its normal, away from the robot, and distance from the map's origin along
  /// it. A post: x and y in metres.
  Eigen::Vector2d parameters = Eigen::Vector2d::Zero();
};

/// How a feature looks from somewhere.
struct FeatureView {
  /// To the nearest point; the range is negative behind a wall.
  double bearing_rad = 0.0;
  double range_m = 0.0;
  /// Derivatives of bearing (first row) and range (second row) by the feature's parameters.
  Eigen::Matrix2d jacobian = Eigen::Matrix2d::Zero();
};

/// What a stop at `center_m` (map frame, metres) sees of a feature.
FeatureView view_from(const Eigen::Vector2d& center_m, const SonarFeature& feature);

/// The features that fit the ranges of both sightings: up to two walls, tangents of the two circles
/// of range, and up to two posts, where the circles cross. None where the places lie too near
/// together.
std::vector<SonarFeature> features_through(const Sighting& first, const Sighting& second);

}  // namespace echomap::mapping
