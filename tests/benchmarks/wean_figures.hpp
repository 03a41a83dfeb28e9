// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "tests/benchmarks/figures.hpp"

namespace echomap::bench {

/// How often the robot of Wean Hall, which may be anywhere, ends within 30 cm and 5 degrees of
/// where many filters agree that logs 1, 3 and 4 end: ten seeds each, from `seed` on. With
/// `verbose` a line a run. Data that is not there is said to be left out.
std::vector<Figure> wean_figures(std::uint32_t seed, bool verbose);

}  // namespace echomap::bench
