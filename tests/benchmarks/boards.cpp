// SPDX-License-Identifier: MIT
// A table of all boards: size, CPU, miscounts, safety and echoes of the release image of each, in
// its emulator.
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "host/files/atomic_file.hpp"
#include "tests/benchmarks/board_program.hpp"
#include "tests/benchmarks/board_table.hpp"
#include "tests/benchmarks/figures.hpp"
#include "tests/benchmarks/measured_boards.hpp"

namespace echomap::bench {
namespace {

BoardColumn measure_column(const MeasuredBoard& board) {
  const BuildFolders folders = build_folders();
  if (const std::string missing = missing_of(board, board.measures, folders); !missing.empty()) {
    return {board.name, "not measured: " + missing + " is not built", board.counts_edges, {}};
  }
  fmt::print(stderr, "{}\n", board.name);
  BoardReport measured = run_measures(board, "table", folders);
  return {board.name, measured.emulator, board.counts_edges, measured.figures};
}

}  // namespace
}  // namespace echomap::bench

int main(int argc, char** argv) {
  using namespace echomap::bench;
  std::vector<std::string> names{"all"};
  std::filesystem::path json;
  std::filesystem::path markdown;
  CLI::App app("A table of the boards, in simulated time");
  app.add_option("--board,--boards", names, "uno, mega, stm32f103, pico, ev3 with commas, or all")
      ->delimiter(',')
      ->capture_default_str();
  app.add_option("--json", json, "Write the figures to this file");
  app.add_option("--markdown", markdown, "Write the table to this file, too");
  CLI11_PARSE(app, argc, argv);
  try {
    std::vector<BoardColumn> columns;
    Notes notes;
    for (const MeasuredBoard& board : boards_named(names)) {
      columns.push_back(measure_column(board));
      notes[board.name] = columns.back().emulator;
    }
    report(figures_by_board(columns), json, notes);
    const std::string table = to_markdown(board_table(columns));
    fmt::print("\n{}", table);
    if (!markdown.empty()) {
      echomap::files::write_text_file(markdown, table);
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_boards: {}\n", error.what());
    return 1;
  }
  return 0;
}
