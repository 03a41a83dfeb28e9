// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "host/mapping/raster_map.hpp"

namespace echomap::bench {

/// What an ideal team is like: it knows its poses, sees a disc from each stop as far as walls let
/// it, and each robot goes to the place that shows most for its time and that no other one goes to.
/// The values are ours: the middle of what a sonar of 2 m and a stop of some seconds allow.
struct IdealTeamParams {
  double view_m = 1.5;
  double stop_s = 5.0;
  double speed_m_per_s = 0.2;
  double robot_radius_m = 0.09;
  /// Two robots share what they see once both have seen so much of the same floor; 0: always.
  double shared_m2 = 4.0;
  double enough_share = 0.9;  ///< Of the floor in reach, which ends it.
  double cell_m = 0.1;        ///< Floor and ways are on a lattice so fine,
  double place_m = 0.2;       ///< and the places to look from on one so fine.
};

/// How long such a team takes until those who share have seen enough of the floor that the first
/// robot can reach. `floor` has free cells where there is floor; `starts_m` are in its frame, one
/// for each robot. A bound in its spirit only: greedy, and not the best that could be done. Empty
/// where it never has enough. Throws std::invalid_argument for no start or invalid parameters.
std::optional<double> ideal_team_s(const mapping::RasterMap& floor,
                                   const std::vector<Eigen::Vector2d>& starts_m,
                                   const IdealTeamParams& params = {});

}  // namespace echomap::bench
