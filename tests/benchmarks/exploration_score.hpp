// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/benchmarks/exploration_entry.hpp"
#include "tests/benchmarks/exploration_runs.hpp"
#include "tests/benchmarks/figures.hpp"
#include "tests/benchmarks/markdown_table.hpp"

namespace echomap::bench {

/// The runs of one strategy in one room.
struct ExplorationCell {
  ExplorationEntry entry;
  int seeds = 0;  ///< That were asked for; a run without a score is none of `runs`.
  std::vector<ExplorationRun> runs{};

  /// How many runs fulfil a condition.
  int count(const std::function<bool(const ExplorationRun&)>& condition) const;
  /// How many of 20 seeds do, were they as these.
  double of_20(const std::function<bool(const ExplorationRun&)>& condition) const;
  /// Over the runs; 0 without any.
  double median(const std::function<double(const ExplorationRun&)>& value) const;
};

/// Figures named ROOM.STRATEGY.FIGURE: medians over the runs; `hard_collisions` adds up, and a map
/// without a wall counts as 1 m off. None for an entry that does not run.
std::vector<Figure> cell_figures(const ExplorationCell& cell);

/// The fastest other strategy, by median time, that ends by itself, is complete in a room in three
/// of four seeds and whose map is as good; null where none is.
const ExplorationCell* best_peer(const std::vector<ExplorationCell>& cells,
                                 const std::string& room,
                                 double min_free_iou = 0.0);

/// frontier over all rooms: medians of the rooms' medians, and what share of its runs is without a
/// collision harder than a bump. `frontier_time_ratio` is its time over that of the best peer,
/// `frontier_time_ratio_to_like_maps` over that of the best with 90 % of its `free_iou`, both where
/// there is one; `frontier_wall_rmse_m_to_4m` is over rooms of at most 4 x 4 m.
std::vector<Figure> frontier_figures(const std::vector<ExplorationCell>& cells);

/// The robot's name where the case has its file.
std::string robot_name(const ExplorationCase& what);

/// Names of the columns of `score_texts`.
std::vector<std::string> score_columns();
/// A cell's scores for people, from how many runs were complete on; why it did not run, where it
/// did not.
std::vector<std::string> score_texts(const ExplorationCell& cell);

/// A row for each room and strategy, those that do not run included.
MarkdownTable rooms_table(const std::vector<ExplorationCell>& cells);

}  // namespace echomap::bench
