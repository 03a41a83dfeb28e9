// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <random>

#include "host/localization/particles.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::localization {

/// So many poses anywhere on the free cells of a map, each as likely as any other (Singh and Bedi
/// 2013, Algorithm 1, line 2); none where no cell is free.
Particles scattered_particles(const mapping::RasterMap& map,
                              std::size_t count,
                              std::mt19937& random);

}  // namespace echomap::localization
