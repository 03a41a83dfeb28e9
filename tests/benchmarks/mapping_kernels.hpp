// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "tests/benchmarks/figures.hpp"

namespace echomap::bench {

/// Rates of the mapping kernels on one thread, with the peers that this was built with: medians of
/// `repetitions` in which ours and theirs take turns, by the processor time of the thread.
std::vector<Figure> kernel_figures(std::size_t repetitions);

}  // namespace echomap::bench
