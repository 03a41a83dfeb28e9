// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "tests/benchmarks/figures.hpp"

namespace echomap::bench {

/// What it costs to record a demo of ten minutes of robot time: processor time, by playing its
/// frames with and without a recorder that sees all that it sees live, and bytes.
std::vector<Figure> cost_figures();

}  // namespace echomap::bench
