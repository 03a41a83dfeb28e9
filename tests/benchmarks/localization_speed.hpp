// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "tests/benchmarks/figures.hpp"

namespace echomap::bench {

/// The kernels of localization in the building's map beside MRPT's, beside themselves on a
/// processor without AVX (`sse4`, `sse2`), with many particles and on two threads. Says so and
/// gives none where that map is absent.
std::vector<Figure> localization_speed_figures(std::size_t repetitions);

}  // namespace echomap::bench
