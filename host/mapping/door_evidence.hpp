// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "host/mapping/surface_matching.hpp"

namespace echomap::mapping {

/// When what stops have heard of a wall leaves room for a door in it. Ours, chosen in simulated
/// rooms.
struct DoorEvidenceParams {
  /// Doors that are asked for, along the wall from step to step: a narrow one. Of a wider one less
  /// is heard.
  double door_m = 0.7;
  double step_m = 0.05;
  /// Student's t of a stop's range to a wall against where all stops together have it. Of 681
  /// simulated ranges 68 % were within 1.3 cm, 98 % within 3.5 cm.
  double range_scale_m = 0.0115;
  double range_degrees_of_freedom = 4.0;
  /// A wall is sure there from these odds on, as a natural logarithm. Two stops have spoken for
  /// wall where there was a door with up to 2.3.
  double sure_log_odds = 2.5;
  /// Where a wall was heard beyond the beam's edges, so much of it fits in no door; but for what
  /// was heard from farther off than this: from there half a door is less than 6 cm longer, which
  /// a region's readings do not tell (SonarSurfaceParams::max_longer_m).
  double max_sure_m = 0.1;
  double sure_distance_m = 1.0;
  /// Doors that are told apart.
  double apart_m = 0.35;
};

/// By how much what was heard speaks for wall there, not for a door: the log-likelihood ratio of
/// the echoes of stops before it. A wall answers from the foot of the perpendicular, a door from
/// the nearer side of its frame, which is as far off where the foot is beside it.
double wall_log_odds(const MatchedWall& wall,
                     const MatchedWall::Piece& door,
                     const DoorEvidenceParams& params);

/// The likeliest doors in the pieces of a wall, of those that echoes leave room for although some
/// stop has its foot there.
std::vector<MatchedWall::Piece> doors_left_by_echoes(const MatchedWall& wall,
                                                     const DoorEvidenceParams& params);

}  // namespace echomap::mapping
