// SPDX-License-Identifier: MIT
#pragma once

#include "host/mapping/raster_map.hpp"

namespace echomap::mapping {

/// The map with thin unknown pieces as floor: an unknown cell stays unknown only in a square of
/// that side length, in whole cells, without floor. So an unknown patch that touches a wall by its
/// tip alone is a patch in the room, and the room's border follows the wall.
RasterMap without_unknown_slivers(const RasterMap& map, double width_m);

}  // namespace echomap::mapping
