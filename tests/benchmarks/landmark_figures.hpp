// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "tests/benchmarks/figures.hpp"

namespace echomap::bench {

/// How well the filter of poses follows robots among known landmarks, MRCLAM set 6 and Brenner's
/// LEGO, and how many places an NXT knows again. With `verbose` a line a robot. A log that is not
/// there is said to be left out.
std::vector<Figure> landmark_figures(bool verbose);

}  // namespace echomap::bench
