// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include <Eigen/Core>

#include "host/exploration/cell_values.hpp"
#include "host/exploration/view_gain.hpp"
#include "host/mapping/distance_field.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::source_search {

/// The floor on which a source is searched: what the map knows, and what it has not seen.
struct SourceFloor {
  /// A map that is whole and right: its unknown cells are air.
  // NOLINTNEXTLINE(google-explicit-constructor,hicpp-explicit-conversions): a map is a floor
  SourceFloor(mapping::RasterMap known_map);
  /// A map in the making, by sonar. Unknown cells are floor as often as looks in vain and walls
  /// beside leave it (exploration::ViewGain::floor_share).
  SourceFloor(mapping::RasterMap known_map, const exploration::ViewGain& gain);

  mapping::RasterMap map;
  /// By cell: 1 for known floor, 0 for what is occupied, and how likely it is floor for unknown.
  exploration::CellValues<float> floor_share;
  /// Floor that is expected beyond the cells of the map that may hold the source.
  double unseen_m2 = 0.0;
  /// The map is still made: what it has of walls, and of shadows behind them, is a guess.
  bool is_in_the_making = false;
  /// Of all places on it together, against where they truly are: SLAM's of the robot's position.
  double position_stddev_m = 0.0;
};

/// How a floor goes on over unknown cells.
struct UnknownReach {
  /// By cell, how likely a way over floor leads there from what is known: as likely as the least
  /// likely cell of the best way is floor. 1 for known floor, 0 for what is occupied or too far.
  exploration::CellValues<float> share;
  exploration::CellValues<std::int32_t> steps;  ///< Of that way, through unknown cells.
};

/// As far as so many steps.
UnknownReach unknown_reach(const SourceFloor& floor, std::int32_t max_steps);

/// The floor that is expected farther than `reach_m` from what is known, where each way over
/// unknown cells that is not at its end there goes on for `beyond_m`. Ways are weighed over their
/// last `shell_m`.
double floor_beyond_m2(const SourceFloor& floor, double reach_m, double shell_m, double beyond_m);

/// How far each cell is from the nearest that is known to be floor, up to `max_m`.
mapping::DistanceField distances_to_known_floor(const mapping::RasterMap& map, double max_m);

/// Whether so little of the straight line is occupied, and so little of it not known to be floor.
bool is_in_sight(const mapping::RasterMap& map,
                 const Eigen::Vector2d& from_m,
                 const Eigen::Vector2d& to_m,
                 double max_solid_m,
                 double max_unknown_m);

}  // namespace echomap::source_search
