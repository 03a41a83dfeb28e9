// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "tests/benchmarks/figures.hpp"

namespace echomap::bench {

/// What it takes to look for a robot's map in one and in three previous maps of a living room:
/// processor time of one core for each stop, the median of `repetitions`.
std::vector<Figure> joining_figures(std::size_t repetitions);

}  // namespace echomap::bench
