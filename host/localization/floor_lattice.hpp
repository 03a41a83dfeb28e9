// SPDX-License-Identifier: MIT
#pragma once

#include "host/localization/particles.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::localization {

/// All poses on the free cells of a map, in steps of about `spacing_m` and `spacing_rad`: a robot
/// that may be anywhere is near one of them.
Particles floor_lattice(const mapping::RasterMap& map, double spacing_m, double spacing_rad);

}  // namespace echomap::localization
