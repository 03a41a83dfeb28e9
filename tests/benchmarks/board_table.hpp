// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "tests/benchmarks/figures.hpp"
#include "tests/benchmarks/markdown_table.hpp"

namespace echomap::bench {

/// What was measured on a board.
struct BoardColumn {
  std::string board;
  std::string emulator;  ///< Its name and version; of a board that was not measured, why not.
  bool counts_edges = true;
  std::vector<Figure> figures;
};

/// A column for each board: flash, RAM, CPU, miscounts by rate and jitter, stop after silence, hang
/// and crash to PWM off, echo error. "-" where there is no figure.
MarkdownTable board_table(const std::vector<BoardColumn>& boards);

/// What a program that measures one board says.
struct BoardReport {
  std::string emulator;
  std::vector<Figure> figures;
};

/// From its JSON. Throws nlohmann::json::exception where it is none.
BoardReport read_board_report(const std::string& json, const std::string& board);

/// Those of all boards with their board's name in front, unless they begin or end with it.
std::vector<Figure> figures_by_board(const std::vector<BoardColumn>& boards);

}  // namespace echomap::bench
