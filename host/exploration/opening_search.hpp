// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>

#include "host/mapping/placed_reading.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::exploration {

/// The values are ours, chosen in simulation.
struct OpeningParams {
  /// A robot that steps into an opening stands so far beyond the last free floor.
  double step_m = 0.2;
  /// So far around that place, and around the edge before it, nothing occupied may be: less than
  /// half of a door.
  double half_width_m = 0.22;
  /// A wall along the edge of the floor answers a beam that meets it this nearly at right angles,
  double square_rad = 0.26;
  /// from no farther off than this.
  double far_m = 2.5;
  /// The readings this near to a direction tell of it.
  double look_half_angle_rad = 0.14;
};

/// Where known floor ends and the way goes on.
struct Opening {
  Eigen::Vector2d edge_m = Eigen::Vector2d::Zero();    ///< On the last free floor.
  Eigen::Vector2d beyond_m = Eigen::Vector2d::Zero();  ///< A step from there, on unknown floor.
};

/// Openings in what is known, which one of the stops, whose scans are in the map frame, has
/// listened through without an answer. Silence along a corridor, where a wall across it would have
/// answered, is no wall that throws sound aside: there the way goes on. One for each cell that lies
/// a step beyond free floor.
std::vector<Opening> find_openings(const mapping::RasterMap& map,
                                   const std::vector<mapping::Scan>& scans,
                                   const OpeningParams& params);

}  // namespace echomap::exploration
