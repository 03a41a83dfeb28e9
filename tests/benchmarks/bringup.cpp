// SPDX-License-Identifier: MIT
// The demo over many seeds: medians of its scores, and how many of the runs ended by themselves.
#include <filesystem>

#include <CLI/CLI.hpp>

#include "tests/benchmarks/demo_runs.hpp"
#include "tests/benchmarks/figures.hpp"

int main(int argc, char** argv) {
  using namespace echomap::bench;
  DemoRuns options;
  std::filesystem::path json;
  bool check = false;
  CLI::App app("Medians of the demo's scores over many seeds");
  app.add_option("--seeds", options.seeds, "Run seeds 1 to this")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--world", options.world)->capture_default_str();
  app.add_option("--robot", options.robot)->capture_default_str();
  auto* emulator = app.add_option("--emulator", options.emulator)->capture_default_str();
  app.add_option("--board", options.board, "Instead of --emulator")->excludes(emulator);
  app.add_option("--driver", options.driver, "As the demo takes it");
  app.add_option("--line", options.line, "As the demo takes it")->capture_default_str();
  app.add_option("--faults", options.faults, "As the demo takes it");
  app.add_option("--json", json, "Write the figures to this file");
  app.add_flag("--check",
               check,
               "Exit with 1 unless every run ends by itself and the medians are within the bounds "
               "of living_room: free_iou >= 0.85, wall_rmse_m <= 0.06");
  CLI11_PARSE(app, argc, argv);
  const auto figures = measure_demos(options);
  report(figures, json);
  return !check || demos_pass(figures, options.seeds) ? 0 : 1;
}
