// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "tests/benchmarks/figures.hpp"

namespace echomap::bench {

/// Whether fleets on a broker that is killed, delayed, stalled and cut end with the same, for so
/// many seeds from 1 on, and how many of 10,000 retained objects one gets who joins late. Says each
/// seed that fails on stderr.
std::vector<Figure> exchange_figures(std::uint32_t seeds);

}  // namespace echomap::bench
