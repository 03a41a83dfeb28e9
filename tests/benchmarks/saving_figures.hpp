// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "tests/benchmarks/figures.hpp"

namespace echomap::bench {

/// What it takes to save, after a stop, the record and the pose graph of a robot that has explored
/// by SLAM for twenty minutes: their sizes, and times by the wall clock, flushed to the disk of the
/// temporary folder, medians of `repetitions`.
std::vector<Figure> saving_figures(std::size_t repetitions);

}  // namespace echomap::bench
