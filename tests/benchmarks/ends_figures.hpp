// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "tests/benchmarks/figures.hpp"
#include "tests/benchmarks/markdown_table.hpp"
#include "tests/benchmarks/truth_runs.hpp"

namespace echomap::bench {

/// What a strategy and the one that it is compared with have made of a room.
struct EndsCell {
  std::string room;
  std::size_t seeds = 0;
  std::vector<TruthRun> runs;
  std::vector<TruthRun> peer_runs;
};

/// A run that is finished with less of the floor in reach than this on its map is falsely so.
constexpr double kTrulyFinishedShare = 0.95;

/// complete_of_320 and false_complete_of_320 count runs of all rooms, however many there were;
/// complete_least is the least share of a room; time_ratio the median over rooms of the robot's
/// time over that of the peer, medians of finished runs, where both finish in half of their runs or
/// more; coverage_bias the mean of what finished maps say they have and what they have of the
/// floor; walls_within_median and walls_within_p90 the shares of runs whose walls are at
/// most as wrong as their maps say that half and nine in ten are. The same of each room as
/// ROOM.FIGURE.
std::vector<Figure> ends_figures(const std::vector<EndsCell>& cells);

/// A row for each room.
MarkdownTable ends_table(const std::vector<EndsCell>& cells);

}  // namespace echomap::bench
