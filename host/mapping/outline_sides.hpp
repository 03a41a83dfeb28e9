// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "host/geometry/polygon.hpp"
#include "host/geometry/segment.hpp"
#include "host/mapping/line_sequence.hpp"
#include "host/mapping/outline_lines.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::mapping {

/// How a border becomes straight sides.
struct OutlineSideParams {
  OutlineLineParams lines;
  LineSequenceParams sequence;
  /// Where sides cross, the smaller loop is cut off up to this area.
  double max_loop_m2 = 0.02;
};

/// Simplifies a border of the free floor to straight sides: those along a fitted wall take its
/// line, neighbours meet where their lines cross. `border_m` is a ring of `free_floor_rings` of
/// `map`, with the floor to the left; so do `walls`. As few lines as possible are given up for no
/// sides to cross. May return fewer than three corners.
geometry::Polygon straight_outline(const geometry::Polygon& border_m,
                                   const RasterMap& map,
                                   const std::vector<geometry::Segment>& walls,
                                   const OutlineSideParams& params);

}  // namespace echomap::mapping
