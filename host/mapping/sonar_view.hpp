// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "host/mapping/placed_reading.hpp"

namespace echomap::mapping {

/// One direction of a view, in the map frame; empty where nothing answered.
struct SonarBeam {
  double bearing_rad = 0.0;
  std::optional<double> range_m;
};

/// All that a sonar has heard from one place. Its readings go together: they are of one moment, and
/// none counts as a second witness of another.
struct SonarView {
  Eigen::Vector2d origin_m = Eigen::Vector2d::Zero();
  std::vector<SonarBeam> beams;
  /// Where the robot's middle was; empty where it is not known.
  std::optional<Eigen::Vector2d> robot_m = std::nullopt;
};

/// The views of a scan, in its order: a new one begins where the transducer has moved by more than
/// `same_place_m`. Of readings in one direction the middle one counts, silence being the farthest.
std::vector<SonarView> views_of(const Scan& scan, double same_place_m);

}  // namespace echomap::mapping
