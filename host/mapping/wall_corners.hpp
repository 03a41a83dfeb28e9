// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "host/mapping/sonar_surfaces.hpp"
#include "host/mapping/surface_matching.hpp"

namespace echomap::mapping {

/// When a wall is prolonged to a corner that no echo came from. Ours, chosen in simulated rooms.
struct CornerJoiningParams {
  /// A sonar hears a wall only from before it, so that the last part up to a corner stays unheard
  /// where the robot does not come near. Farther than this a wall is not prolonged.
  double reach_m = 0.6;
  /// Walls that meet at less than this are one wall, or none.
  double min_angle_rad = 0.5;
  /// What was heard this much behind a wall was heard through a gap in it.
  double behind_m = 0.12;
};

/// Prolongs pieces of walls to the corner with another wall, where both come near enough to it and
/// no surface of `scans` has been heard through the gap.
std::vector<MatchedWall> joined_at_corners(std::vector<MatchedWall> walls,
                                           const std::vector<ScanSurfaces>& scans,
                                           const CornerJoiningParams& params);

}  // namespace echomap::mapping
