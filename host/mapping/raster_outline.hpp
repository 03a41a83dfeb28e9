// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "host/geometry/polygon.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::mapping {

/// The border of the largest connected piece of free floor, along the edges of its cells, in metres
/// of the map frame: first its outline, counter-clockwise, then the borders of what it encloses,
/// clockwise. No ring touches itself or another: where two cells of the floor meet in a corner
/// alone, one of them is given up. Empty where no cell is free.
std::vector<geometry::Polygon> free_floor_rings(const RasterMap& map);

}  // namespace echomap::mapping
