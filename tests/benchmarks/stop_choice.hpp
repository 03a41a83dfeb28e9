// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "hil_mock/world/floor_plan.hpp"

namespace echomap::bench {

/// What a list of stops has to show of a room; ours, chosen so that a room of 4 x 3 m gets about 20
/// stops.
struct StopChoiceParams {
  /// Floor counts as seen in line of sight from within this.
  double floor_reach_m = 1.6;
  /// A wall counts as met from within this, in line of sight and so near to the perpendicular: the
  /// sonar loses a smooth wall at 25 degrees.
  double wall_reach_m = 2.0;
  double max_incidence_rad = 0.35;
  /// Each floor cell is to be seen, and each piece of a wall to be met, from so many stops; every
  /// further one is worth half of the one before it.
  int views = 4;
  /// A stop is worth it that shows so much, square metres of floor and metres of wall together, for
  /// each metre of the side of a square room as large as this one.
  double min_gain_per_side_m = 0.09;
  /// Stops are so far apart, as a share of that side.
  double apart_share = 0.1;
  /// No candidate is farther from the nearest stop, as a share of that side: stops are spread even
  /// where a few show everything.
  double max_gap_share = 0.2;
  std::size_t max_stops = 100;
  /// Lattice of floor, and length of pieces of wall.
  double floor_step_m = 0.15;
  double wall_step_m = 0.1;
};

/// Chooses stops among `candidates_m`, all in the world frame, greedily: first `first_m`, then
/// always the one that shows most that has been seen too seldom, until none is worth it, and then
/// those that are farthest from all stops.
std::vector<Eigen::Vector2d> choose_stops(const world::FloorPlan& plan,
                                          const std::vector<Eigen::Vector2d>& candidates_m,
                                          const Eigen::Vector2d& first_m,
                                          const StopChoiceParams& params = {});

}  // namespace echomap::bench
