// SPDX-License-Identifier: MIT
// The demo over many seeds, on one board or on several: medians of its scores, and how many of the
// runs ended by themselves.
#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "tests/benchmarks/board_comparison.hpp"
#include "tests/benchmarks/demo_runs.hpp"
#include "tests/benchmarks/figures.hpp"
#include "tests/benchmarks/measured_boards.hpp"

namespace echomap::bench {
namespace {

/// What the command line says.
struct Bringup {
  DemoRuns demo;
  std::vector<std::string> boards;
  bool robot_is_named = false;
  std::filesystem::path json;
  bool check = false;
};

/// Status of a program whose check fails.
constexpr int kFailed = 1;

BoardRuns run_board(const MeasuredBoard& board, const Bringup& options, Notes& notes) {
  const std::string missing = missing_of(board, board.program, build_folders());
  if (!missing.empty()) {
    notes[board.name] = "not run: " + missing + " is not built";
    return {board.name, missing, {}, false};
  }
  fmt::print(stderr, "{}: {} seeds\n", board.name, options.demo.seeds);
  DemoRuns runs = options.demo;
  runs.board = board.name;
  runs.robot = options.robot_is_named ? runs.robot : board.robot;
  const DemoFigures demos = measure_demos(runs);
  notes[board.name] = demos.emulator.empty() ? "no run ended" : demos.emulator;
  return {board.name, "", demos.figures, demos_pass(demos.figures, runs.seeds)};
}

int run_boards(const Bringup& options) {
  Notes notes;
  std::vector<BoardRuns> runs;
  for (const MeasuredBoard& board : boards_named(options.boards)) {
    runs.push_back(run_board(board, options, notes));
  }
  const bool is_one = runs.size() == 1 && runs.front().missing.empty();
  const auto figures = compare_boards(runs);
  report(is_one ? runs.front().figures : figures, options.json, notes);
  const bool all_pass = value_of(figures, "boards_passing") == double(runs.size());
  return !options.check || all_pass ? 0 : kFailed;
}

int run_emulator(const Bringup& options) {
  const DemoFigures demos = measure_demos(options.demo);
  report(demos.figures, options.json, {{options.demo.emulator, demos.emulator}});
  return !options.check || demos_pass(demos.figures, options.demo.seeds) ? 0 : kFailed;
}

}  // namespace
}  // namespace echomap::bench

int main(int argc, char** argv) {
  using namespace echomap::bench;
  Bringup options;
  options.demo.jobs = 2;
  DemoRuns& demo = options.demo;
  CLI::App app("Medians of the demo's scores over many seeds");
  app.add_option("--seeds", demo.seeds, "Run seeds 1 to this")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--world", demo.world)->capture_default_str();
  auto* robot = app.add_option("--robot", demo.robot, "By default the board's");
  auto* emulator = app.add_option("--emulator", demo.emulator)->capture_default_str();
  app.add_option("--board,--boards",
                 options.boards,
                 "Instead of --emulator: uno, mega, stm32f103, pico, ev3, with commas between, or "
                 "all; several are compared")
      ->delimiter(',')
      ->excludes(emulator);
  app.add_option("--driver", demo.driver, "As the demo takes it");
  app.add_option("--line", demo.line, "As the demo takes it")->capture_default_str();
  app.add_option("--faults", demo.faults, "As the demo takes it");
  app.add_option("--jobs", demo.jobs, "Runs at a time")
      ->check(CLI::Range(1, 64))
      ->capture_default_str();
  app.add_option("--json", options.json, "Write the figures to this file");
  app.add_flag(
      "--check",
      options.check,
      "Exit with 1 unless every run finishes by itself and the medians are within the bounds "
      "of living_room: free_iou >= 0.85, wall_rmse_m <= 0.06; of several boards, unless "
      "those of free_iou are within 0.01 of each other, too");
  CLI11_PARSE(app, argc, argv);
  options.robot_is_named = robot->count() > 0;
  try {
    return options.boards.empty() ? run_emulator(options) : run_boards(options);
  } catch (const std::invalid_argument& error) {
    fmt::print(stderr, "bench_bringup: {}\n", error.what());
    return 2;
  }
}
