// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "host/mapping/placed_reading.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::mapping {

/// All that a sonar has heard from one place. Its readings go together: they are of one moment, and
/// none counts as a second witness of another.
struct SonarView {
  Eigen::Vector2d origin_m = Eigen::Vector2d::Zero();
  std::vector<sensors::Beam> beams;  ///< Bearings in the map frame.
  /// Where the robot's middle was; empty where it is not known.
  std::optional<Eigen::Vector2d> robot_m = std::nullopt;
};

/// The views of a scan, in its order: a new one begins where the transducer has moved by more than
/// `same_place_m`. Of readings in one direction the middle one counts, silence being the farthest.
std::vector<SonarView> views_of(const Scan& scan, double same_place_m);

}  // namespace echomap::mapping
