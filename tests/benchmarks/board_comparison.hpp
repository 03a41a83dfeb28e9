// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "tests/benchmarks/figures.hpp"

namespace echomap::bench {

/// Medians of `free_iou` of two boards that do the same differ by no more.
inline constexpr double kMaxFreeIouSpread = 0.01;

/// What the demos on one board came to.
struct BoardRuns {
  std::string board;
  std::string missing;  ///< What is not built, so that nothing was run.
  std::vector<Figure> figures;
  bool passes = false;  ///< Every run and every median, as `bench bringup --check` demands.
};

/// Every board's figures under its name, then `free_iou_spread` over the boards that were run and
/// `boards_passing`: the most boards that pass and whose medians of free_iou are all within
/// kMaxFreeIouSpread of each other.
std::vector<Figure> compare_boards(const std::vector<BoardRuns>& boards);

/// The value of the figure of that name. Throws std::invalid_argument where there is none.
double value_of(const std::vector<Figure>& figures, const std::string& name);

}  // namespace echomap::bench
