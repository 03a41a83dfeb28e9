// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/evaluation/run_score.hpp"
#include "tests/benchmarks/figures.hpp"
#include "tests/benchmarks/markdown_table.hpp"
#include "tests/benchmarks/truth_runs.hpp"

namespace echomap::bench {

/// All that was measured in one room.
struct TruthCell {
  std::string room;
  bool is_small = false;
  std::size_t stops = 0;  ///< Of the list; 0 where a strategy chooses.
  std::vector<TruthRun> runs;
  std::vector<TruthRun> rough_runs;              ///< With rough odometry.
  std::optional<evaluation::PlacedScore> ideal;  ///< The ideal map of the same stops.
};

/// Medians over rooms of medians over seeds, placed by the first pose; the same fitted as
/// `fitted_..`; with rough odometry as `rough_..`, fitted, and the difference to the usual robot as
/// `rough_.._change`; and what the ideal maps score as peer "ideal". A figure that no room has is
/// left out.
std::vector<Figure> truth_figures(const std::vector<TruthCell>& cells);

/// The scores of each room as ROOM.FIGURE, in the same three ways.
std::vector<Figure> room_figures(const TruthCell& cell);

/// A row for each room and way of placing its map, and one for all.
MarkdownTable truth_table(const std::vector<TruthCell>& cells);

}  // namespace echomap::bench
