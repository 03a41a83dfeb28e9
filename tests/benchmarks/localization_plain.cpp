// SPDX-License-Identifier: MIT
// The kernels of localization compiled for one kind of processor, without a choice at run time.
#include <filesystem>

#include <CLI/CLI.hpp>

#include "tests/benchmarks/building_runs.hpp"
#include "tests/benchmarks/localization_kernels.hpp"
#include "tests/support/real_data.hpp"

int main(int argc, char** argv) {
  std::size_t repetitions = 25;
  std::filesystem::path json;
  CLI::App app("The kernels of localization, for one kind of processor");
  app.add_option("--repetitions", repetitions, "Median of so many")->capture_default_str();
  app.add_option("--json", json, "Write the figures to this file");
  CLI11_PARSE(app, argc, argv);
  using namespace echomap;
  const auto map = bench::read_building(tests::real_data("global_localization/map.pgm"));
  bench::report(bench::localization_kernel_figures(map, repetitions), json);
}
