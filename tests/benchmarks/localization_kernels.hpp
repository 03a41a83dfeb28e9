// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "host/mapping/raster_map.hpp"
#include "tests/benchmarks/figures.hpp"

namespace echomap::bench {

/// Processor time of the parts of a particle filter, 10,000 particles around one pose in a map of
/// the building, one thread.
std::vector<Figure> localization_kernel_figures(const mapping::RasterMap& map,
                                                std::size_t repetitions);

}  // namespace echomap::bench
