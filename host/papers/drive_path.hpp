// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>

#include "host/geometry/pose2.hpp"

namespace echomap::papers {

/// How finely a drive is cut into poses.
struct PathSteps {
  double length_m = 0.005;
  double turn_rad = 0.19;
};

/// Poses of a robot that goes from point to point in straight lines and turns on the spot in each.
/// The first lies `phase` of a step behind the first point.
std::vector<geometry::Pose2> drive_path(const std::vector<Eigen::Vector2d>& points_m,
                                        const PathSteps& steps,
                                        double phase = 0.0);

}  // namespace echomap::papers
