// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "host/mapping/raster_map.hpp"
#include "tests/benchmarks/figures.hpp"

namespace echomap::bench {

/// What a whole step costs a particle where there are 100,000 and a million, and how much sooner
/// two threads are done with as many steps as make 100,000 particles, one after the other: by the
/// wall clock, the fastest of pairs on one thread and on two. Says how busy the machine was.
std::vector<Figure> localization_scaling_figures(const mapping::RasterMap& map,
                                                 std::size_t repetitions);

}  // namespace echomap::bench
