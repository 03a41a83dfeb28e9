// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>

#include "hil_mock/world/floor_plan.hpp"
#include "host/evaluation/map_agreement.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::bench {

/// A room as `echomap eval` reads it from a truth directory.
evaluation::MapTruth truth_of(const world::FloorPlan& plan);

/// What the best map of some stops shows.
struct IdealMapParams {
  double cell_m = 0.05;
  /// Floor and walls show as far as this.
  double reach_m = 3.0;
  /// A wall shows where it is met so near to the perpendicular: 26 degrees.
  double max_incidence_rad = 0.4537856055185257;
};

/// The map that stops make whose poses and readings have no error, in the map frame: true floor in
/// line of sight of a stop is free, the cells half a cell behind the face of walls that a stop
/// meets are occupied, and the rest is unknown. `stops_m` are in the world frame.
mapping::RasterMap ideal_map(const world::FloorPlan& plan,
                             const evaluation::MapTruth& truth,
                             const std::vector<Eigen::Vector2d>& stops_m,
                             const IdealMapParams& params = {});

}  // namespace echomap::bench
