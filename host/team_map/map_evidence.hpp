// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "host/geometry/pose2.hpp"
#include "host/team_map/robot_map.hpp"

namespace echomap::team_map {

/// What the readings of two robots say of a place of the second one's map in the first one's: those
/// of either in what the other one knows, silences included. Log-likelihoods; neighbours in a beam
/// share their errors, so that a reading is worth far less than a measurement. Those of a stop
/// share the error of its pose besides: all that one has together count as one sweep at most.
struct MapEvidence {
  /// That fall where the other robot knows the floor, and what ends it.
  double readings = 0.0;
  /// By how much better the other map explains them than a room of which nothing is known.
  double gain = 0.0;
  /// By how much worse than the robot's own other stops do.
  double loss = 0.0;
  std::size_t surfaces = 0;  ///< That the other robot should have seen,
  std::size_t matched = 0;   ///< and those of them that it has.

  double loss_per_reading() const { return readings == 0.0 ? 0.0 : loss / readings; }
  double matched_share() const {
    return surfaces == 0 ? 0.0 : static_cast<double>(matched) / static_cast<double>(surfaces);
  }
  /// To compare places: a look-alike explains much, and badly.
  double weight() const { return gain - 2.0 * loss; }
};

/// Moves a placement to where the walls and posts that each of both has seen fit the ranges of the
/// other one best: least squares over x, y and heading, some steps.
geometry::Pose2 refined_placement(const RobotMap& first,
                                  const RobotMap& second,
                                  const geometry::Pose2& T_first_second);

/// Judges a placement.
MapEvidence evidence_for(const RobotMap& first,
                         const RobotMap& second,
                         const geometry::Pose2& T_first_second);

}  // namespace echomap::team_map
