// SPDX-License-Identifier: MIT
#pragma once

#include "host/mapping/raster_map.hpp"

namespace echomap::localization {

/// A map of which a ray that leaves it also leaves the known floor.
inline mapping::RasterMap with_unknown_ring(const mapping::RasterMap& map) {
  return mapping::cut_out(map, {{-1, -1}, {map.columns(), map.rows()}});
}

/// Whether a ray that comes so far over known floor, and so far before it meets a surface, has the
/// unknown in between. Walls may have a seam of unknown cells before them.
inline bool leaves_known_floor(float floor_m, float surface_m) {
  constexpr float kSeamM = 0.15F;
  return floor_m + kSeamM < surface_m;
}

}  // namespace echomap::localization
