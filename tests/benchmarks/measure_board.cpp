// SPDX-License-Identifier: MIT
// Figures of a board in this program's emulator. No program may link two (their licences do not
// fit), so there is one for each; `bench link` and `bench boards` start the right one.
#include <exception>
#include <filesystem>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "tests/benchmarks/board_measures.hpp"
#include "tests/benchmarks/figures.hpp"
#include "tests/benchmarks/measured_boards.hpp"

int main(int argc, char** argv) {
  using namespace echomap::bench;
  std::string name;
  std::string part = "table";
  std::filesystem::path json;
  CLI::App app("Figures of one board, in simulated time");
  app.add_option("--board", name)->required();
  app.add_option("--part", part)->check(CLI::IsMember({"link", "table"}))->capture_default_str();
  app.add_option("--json", json, "Write the figures to this file");
  CLI11_PARSE(app, argc, argv);
  spdlog::set_level(spdlog::level::err);  // a session tells of every reset it has seen
  try {
    const MeasuredBoard board = measured_board(name);
    const BoardUnderMeasure measured{name, image_of(board, build_folders()), board.counts_edges};
    report(part == "link" ? measure_board_link(measured) : measure_board_table(measured),
           json,
           {{name, emulator_of(measured)}});
  } catch (const std::exception& error) {
    fmt::print(stderr, "{} on {}: {}\n", part, name, error.what());
    return 1;
  }
  return 0;
}
