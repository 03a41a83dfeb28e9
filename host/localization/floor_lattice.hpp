// SPDX-License-Identifier: MIT
#pragma once

#include "host/localization/particles.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::localization {

/// Poses all over the floor of a map: in each square of about `spacing_m` the free cell nearest to
/// its middle, with headings `spacing_rad` apart. A robot that may be anywhere is near one of them,
/// in a passage too that is narrower than a square.
Particles floor_lattice(const mapping::RasterMap& map, double spacing_m, double spacing_rad);

}  // namespace echomap::localization
