// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>

#include "host/exploration/cost_grid.hpp"
#include "host/exploration/possible_doors.hpp"
#include "host/exploration/view_gain.hpp"
#include "host/geometry/segment.hpp"
#include "host/pipeline/snapshot.hpp"

namespace echomap::exploration {

/// Values without another source are ours, chosen in simulation.
struct CoverageParams {
  CostGridParams costs;
  ViewGainParams gain;
  PossibleDoorParams doors;
  /// Free floor farther than so many radii of the robot from where it can stand is out of its
  /// reach: a corner is not.
  double corner_radii = 2.0;
  /// Unknown cells of which less is expected to be floor belong to no place: they are behind walls.
  double min_floor_share = 0.3;
  /// Less unseen or unreachable floor in one piece than this is no place to tell of.
  double min_place_m2 = 0.1;
};

/// Unknown floor that borders on what the robot can reach.
struct UnseenPlace {
  Eigen::Vector2d at_m = Eigen::Vector2d::Zero();  ///< Its middle, in the map frame.
  double area_m2 = 0.0;                            ///< What is expected to be floor of it.
};

/// A gap that the robot does not fit through, with free floor behind.
struct NarrowGap {
  Eigen::Vector2d at_m = Eigen::Vector2d::Zero();  ///< Where it is narrowest, in the map frame.
  double width_m = 0.0;                            ///< Between what is occupied to both sides.
  double behind_m2 = 0.0;                          ///< Free floor that only leads there.
};

/// How much of the floor that the robot can reach its map has, by the map itself.
struct Coverage {
  double seen_m2 = 0.0;
  double unseen_m2 = 0.0;           ///< An estimate: silence beside floor may be a wall, too.
  std::vector<UnseenPlace> places;  ///< The largest first.
  std::vector<NarrowGap> gaps;      ///< The one with most floor behind it first.
  /// Stretches of wall that no stop could tell from a door, though the robot can stand before them;
  /// the widest first, the floor to their left. They count nothing as floor.
  std::vector<geometry::Segment> doors{};

  /// Of 1; 0 where nothing was seen.
  double share() const;
};

/// What looks from the floor in reach could still show (after Yamauchi 1997: unknown cells beside
/// free ones), where each counts by ViewGain::floor_share: less beside walls, and less for each
/// look that left it unknown, but in islands. Walls that nobody has heard count by the floor that
/// ViewGain expects behind them, where the robot can stand before them.
Coverage coverage_of(const pipeline::Snapshot& snapshot, const CoverageParams& params = {});

}  // namespace echomap::exploration
