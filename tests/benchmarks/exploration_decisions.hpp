// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "tests/benchmarks/figures.hpp"

namespace echomap::bench {

/// What one decision of the strategy frontier takes, on one thread: from the grid to the way, in
/// cluttered synthetic halls of 400 x 400 and 2000 x 2000 cells of 5 cm of which the farther third
/// is unknown. decision_ms_400 and decision_ms_2000 are medians of `decisions` decisions one after
/// the other, the robot moving on as it decides and its past views adding up; the `_max` ones the
/// longest of them. Where no look promises enough, a decision also searches for openings:
/// opening_search_ms_400 and opening_search_ms_2000, with as many scans as there can be.
std::vector<Figure> decision_figures(std::size_t decisions);

}  // namespace echomap::bench
