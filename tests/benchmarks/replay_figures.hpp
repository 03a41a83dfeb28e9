// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "tests/benchmarks/figures.hpp"

namespace echomap::bench {

/// How much faster than it was driven the Edmonton log becomes a grid, from the packed files on:
/// the median of `runs`. Says so and gives none where the log is absent.
std::vector<Figure> replay_figures(std::size_t runs);

}  // namespace echomap::bench
