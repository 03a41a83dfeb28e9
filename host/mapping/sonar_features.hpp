// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>

#include "host/geometry/segment.hpp"

namespace echomap::mapping {

/// A compact obstacle as a sonar measures it: its face lies on a circle.
struct FittedCircle {
  Eigen::Vector2d center_m = Eigen::Vector2d::Zero();
  double radius_m = 0.0;
};

/// The things that several stops have measured, in the map frame: what a sonar map is drawn from.
struct SonarFeatures {
  /// Straight pieces of wall, prolonged to their corners. The floor is to the left of each.
  std::vector<geometry::Segment> walls;
  std::vector<FittedCircle> circles;
};

}  // namespace echomap::mapping
