// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "host/geometry/pose2.hpp"
#include "host/team_map/robot_map.hpp"

namespace echomap::team_map {

/// Evidence of the readings of two robots for a placement of the second one's map in the first
/// one's: of the readings of either in what the other one knows, readings without an echo included.
/// Log-likelihoods; neighbours in a beam share their errors, so that a reading is worth far less
/// than a measurement. Those of a stop share the error of its pose besides: all of them together
/// count as one sweep at most.
struct MapEvidence {
  /// Number of readings where the other robot knows the floor, and what bounds it.
  double readings = 0.0;
  /// How much better the other map explains them than a room of which nothing is known.
  double gain = 0.0;
  /// How much worse it explains them than the robot's own other stops do.
  double loss = 0.0;
  std::size_t surfaces = 0;  ///< Surfaces that the other robot should have measured,
  std::size_t matched = 0;   ///< and those of them that it has measured.

  double loss_per_reading() const { return readings == 0.0 ? 0.0 : loss / readings; }
  double matched_share() const {
    return surfaces == 0 ? 0.0 : static_cast<double>(matched) / static_cast<double>(surfaces);
  }
  /// Score to compare placements: a look-alike explains many readings, but badly.
  double weight() const { return gain - 2.0 * loss; }
};

/// Refines a placement so that the walls and posts that each robot has measured fit the ranges of
/// the other one best: a few steps of least squares over x, y and heading.
geometry::Pose2 refined_placement(const RobotMap& first,
                                  const RobotMap& second,
                                  const geometry::Pose2& T_first_second);

/// Evidence for a placement.
MapEvidence evidence_for(const RobotMap& first,
                         const RobotMap& second,
                         const geometry::Pose2& T_first_second);

}  // namespace echomap::team_map
