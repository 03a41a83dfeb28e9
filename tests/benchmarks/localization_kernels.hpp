// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "tests/benchmarks/figures.hpp"

namespace echomap::bench {

/// Processor time of the parts of a particle filter, 10,000 particles around one pose in the
/// building's map, one thread. None where that map is absent.
std::vector<Figure> localization_kernel_figures(std::size_t repetitions);

}  // namespace echomap::bench
