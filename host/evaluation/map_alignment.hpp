// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "host/geometry/pose2.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::evaluation {

/// How far two maps of one room may lie apart, and when they agree.
struct MapAlignmentParams {
  /// Their frames, the robot's two starts, differ by at most this much in x, in y and in heading.
  double reach_m = 1.0;
  double reach_rad = 0.5236;  ///< 30 degrees.
  /// Walls of two good maps lie this far apart (twice the `wall_rmse_m` of a run).
  double wall_stddev_m = 0.08;
  /// Maps of which a smaller share of the walls agrees have nothing in common.
  double min_agreement = 0.45;
};

/// Where one map lies on another.
struct MapAlignment {
  geometry::Pose2 T_a_b;
  /// Mean over the occupied cells of b of exp(-d^2 / (2 wall_stddev^2)), d to the nearest of a, and
  /// the other way round; the root of their product: 1 where every wall lies on a wall.
  double agreement = 0.0;
};

/// Lays `b` onto `a`: correlative matching (Olson 2009) of their walls, on a coarse lattice of
/// poses within reach and then finer around the best of them. Empty where they have nothing in
/// common. Throws std::invalid_argument for parameters that are not above zero.
std::optional<MapAlignment> align_maps(const mapping::RasterMap& a,
                                       const mapping::RasterMap& b,
                                       const MapAlignmentParams& params = {});

}  // namespace echomap::evaluation
