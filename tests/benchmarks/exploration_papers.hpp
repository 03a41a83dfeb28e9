// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/benchmarks/exploration_runs.hpp"
#include "tests/benchmarks/exploration_score.hpp"
#include "tests/benchmarks/figures.hpp"
#include "tests/benchmarks/markdown_table.hpp"

namespace echomap::bench {

/// The exploration of one paper, in its room with its robot.
struct PaperExperiment {
  std::string paper;     ///< As the tests of tests/papers name it: "paper_001".
  ExplorationCase what;  ///< On the release image, under simavr.
};

/// Of all four papers. "paper_001_measured" is a Create whose ways are 4 % off, with the fitted
/// line that corrects them; its files go to `folder`.
std::vector<PaperExperiment> paper_experiments(const std::filesystem::path& folder);

/// What a paper's own experiment is about, next to `cell_figures`, named as PAPER.ROOM.FIGURE: for
/// coastal how often the outline was closed and had the room's number of corners, and how far off
/// they were (root mean square over all runs, and of the worst); for epuck how often the walls were
/// within 10 mm; for tangent-bug how often it went in through the door and came back, and reached
/// all of its places.
std::vector<Figure> paper_figures(const std::string& paper, const ExplorationCell& cell);

/// A paper's experiments and what they came to.
struct MeasuredPaper {
  std::string paper;
  ExplorationCell cell;
};

/// A row for each, on which board, and its `paper_figures` in words.
MarkdownTable papers_table(const std::vector<MeasuredPaper>& measured);

}  // namespace echomap::bench
