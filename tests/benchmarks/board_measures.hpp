// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/benchmarks/figures.hpp"

namespace echomap::bench {

/// A board's image in the emulator that this program has, by tests/hil/emulated_board.hpp.
struct BoardUnderMeasure {
  std::string name;  ///< "uno"; figures of its chip end in it.
  std::filesystem::path elf;
  bool counts_edges = true;
};

/// Name and version of the emulator.
std::string emulator_of(const BoardUnderMeasure& board);

/// The figures of `bench link` that depend on the board. What its emulator does not tell is left
/// out.
std::vector<Figure> measure_board_link(const BoardUnderMeasure& board);

/// The figures of the table of `bench boards`: size, CPU, miscounts by rate and jitter, safety,
/// echoes. What its emulator does not tell is left out.
std::vector<Figure> measure_board_table(const BoardUnderMeasure& board);

}  // namespace echomap::bench
