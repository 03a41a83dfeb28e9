// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "host/geometry/cell_index.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::exploration {

/// Frontier cells that hang together by sides or corners.
using FrontierCells = std::vector<geometry::CellIndex>;

/// The frontiers of Yamauchi 1997: free cells beside an unknown one, side by side, that free floor
/// joins to `from`; the largest frontier first. What lies outside of the map is unknown. None where
/// `from` is not free.
std::vector<FrontierCells> find_frontiers(const mapping::RasterMap& map, geometry::CellIndex from);

}  // namespace echomap::exploration
