// SPDX-License-Identifier: MIT
// How often, how fast and at what cost a robot is found in a map.
#include <cstdint>
#include <filesystem>
#include <vector>

#include <CLI/CLI.hpp>

#include "tests/benchmarks/building_figures.hpp"
#include "tests/benchmarks/figures.hpp"
#include "tests/benchmarks/landmark_figures.hpp"
#include "tests/benchmarks/localization_kernels.hpp"
#include "tests/benchmarks/room_figures.hpp"

int main(int argc, char** argv) {
  std::uint32_t seed = 1;
  int starts = 20;
  std::size_t repetitions = 25;
  bool verbose = false;
  std::filesystem::path json;
  CLI::App app("How often, how fast and at what cost a robot is found in a map");
  app.add_option("--seed", seed, "First seed of robots and filters")->capture_default_str();
  app.add_option("--starts", starts, "Robots in each room")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--repetitions", repetitions, "Median of so many")->capture_default_str();
  app.add_flag("--verbose", verbose, "A line for each robot that is followed");
  app.add_option("--json", json, "Write the figures to this file");
  CLI11_PARSE(app, argc, argv);
  std::vector<echomap::bench::Figure> figures =
      echomap::bench::localization_kernel_figures(repetitions);
  for (const auto& more : {echomap::bench::building_figures(seed),
                           echomap::bench::room_figures(starts, seed),
                           echomap::bench::landmark_figures(verbose)}) {
    figures.insert(figures.end(), more.begin(), more.end());
  }
  echomap::bench::report(figures, json);
}
