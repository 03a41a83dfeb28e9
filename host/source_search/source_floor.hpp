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
  /// A complete and correct map: its unknown cells are air.
  // NOLINTNEXTLINE(google-explicit-constructor,hicpp-explicit-conversions): a map is a floor
  SourceFloor(mapping::RasterMap known_map);
  /// An unfinished map by sonar. How likely unknown cells are floor follows from looks without an
  /// echo and from the walls beside (exploration::ViewGain::floor_share).
  SourceFloor(mapping::RasterMap known_map, const exploration::ViewGain& gain);

  mapping::RasterMap map;
  /// By cell: 1 for known floor, 0 for occupied cells, and how likely it is floor for unknown ones.
  exploration::CellValues<float> floor_share;
  /// Floor that is expected beyond the cells of the map that may hold the source, square metres.
  double unseen_m2 = 0.0;
  /// The map is unfinished: its walls, and the shadows behind them, are uncertain.
  bool is_in_the_making = false;
  /// Standard deviation of all places on it together, against where they truly are: that of the
  /// robot's position in SLAM.
  double position_stddev_m = 0.0;
};

/// How a floor continues over unknown cells.
struct UnknownReach {
  /// By cell, how likely a path over floor leads there from known floor: as likely as the least
  /// likely cell of the best path is floor. 1 for known floor, 0 for cells that are occupied or too
  /// far.
  exploration::CellValues<float> share;
  exploration::CellValues<std::int32_t> steps;  ///< Length of that path, in unknown cells.
};

/// Computes the reach over at most `max_steps` unknown cells.
UnknownReach unknown_reach(const SourceFloor& floor, std::int32_t max_steps);

/// Floor that is expected farther than `reach_m` from known floor, square metres, where each path
/// over unknown cells that has not ended by then continues for `beyond_m`. The width of the paths
/// is averaged over their last `shell_m`.
double floor_beyond_m2(const SourceFloor& floor, double reach_m, double shell_m, double beyond_m);

/// Distance of each cell to the nearest that is known to be floor, up to `max_m`.
mapping::DistanceField distances_to_known_floor(const mapping::RasterMap& map, double max_m);

/// Whether at most `max_solid_m` of the straight line is occupied, and at most `max_unknown_m` of
/// it is not known to be floor.
bool is_in_sight(const mapping::RasterMap& map,
                 const Eigen::Vector2d& from_m,
                 const Eigen::Vector2d& to_m,
                 double max_solid_m,
                 double max_unknown_m);

}  // namespace echomap::source_search
