// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "host/geometry/polygon.hpp"
#include "host/geometry/segment.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::mapping {

/// When a border follows a wall and what of it is detail. Ours, chosen in simulated rooms.
struct OutlineSideParams {
  /// The border is first cut into sides that no part of it is farther from.
  double cut_tolerance_m = 0.06;
  /// A side whose border lies within this of a fitted wall, on average, follows that wall.
  double wall_distance_m = 0.10;
  /// Such a side is no farther than this from the fitted part of the wall.
  double wall_gap_m = 0.5;
  /// Steps and notches of the border up to this depth are detail.
  double detail_m = 0.10;
  /// Neighbours that turn by less than this are one side, or parallel ones with a step between.
  double min_turn_rad = 0.26;
  /// An unknown area between two sides that are known is bridged up to this depth.
  double bridged_m = 0.5;
  /// A side is known if it follows a wall, or if it is this long and most of it has occupied cells
  /// behind it.
  double known_length_m = 0.3;
};

/// Simplifies a border of the free floor to straight sides: those along a fitted wall take its
/// line, neighbours meet where their lines cross. `border_m` runs along the edges of the cells of
/// `map`, with the floor to the left; so do `walls`. May return sides that cross each other, or
/// fewer than three corners.
geometry::Polygon straight_outline(const geometry::Polygon& border_m,
                                   const RasterMap& map,
                                   const std::vector<geometry::Segment>& walls,
                                   const OutlineSideParams& params);

}  // namespace echomap::mapping
