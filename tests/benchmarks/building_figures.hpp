// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "tests/benchmarks/figures.hpp"

namespace echomap::bench {

/// How many of the 25 runs of each kind of ring are found at step 20 of the building, within 0.30 m
/// and 15 degrees, and what a step costs. Says so and gives none where the runs are absent. `seed`
/// is the first of the filters'.
std::vector<Figure> building_figures(std::uint32_t seed);

}  // namespace echomap::bench
