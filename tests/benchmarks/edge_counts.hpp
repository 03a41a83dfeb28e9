// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/benchmarks/figures.hpp"

namespace echomap::bench {

/// Rates at which edges are counted, thousands a second of each wheel.
inline constexpr std::array<int, 3> kRatesK{40, 80, 200};
/// How far each edge is displaced at most, percent of its period.
inline constexpr std::array<int, 3> kJittersPercent{0, 20, 40};

/// What a board's counts came to at one rate and jitter.
struct EdgeCount {
  int rate_k = 0;
  int jitter_percent = 0;
  int comparisons = 0;         ///< Reports that were compared with the wheels.
  std::int64_t miscounts = 0;  ///< Largest difference of a count among them, modulo 2^16.
  int lost_steps = 0;          ///< Steps that the firmware reports as lost.
  std::uint32_t resets = 0;    ///< Of the chip.
};

/// "40k_jitter20", as names of its figures end.
std::string suffix_of(int rate_k, int jitter_percent);

/// Three figures for each: `miscounts_`, left out where nothing could be compared, `lost_steps_`
/// and `resets_`.
std::vector<Figure> figures_of(const std::vector<EdgeCount>& counts);

/// The most miscounts among them; infinite where one could not be compared.
double worst_miscounts(const std::vector<EdgeCount>& counts);

}  // namespace echomap::bench
