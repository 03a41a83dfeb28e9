// SPDX-License-Identifier: MIT
// The firmware above its hardware layer in random worlds, compiled for AVR, ARM and this machine:
// every output compared.
#include "tests/hil/measure/differential.hpp"

#include <cstdint>
#include <filesystem>

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include "tests/benchmarks/figures.hpp"

int main(int argc, char** argv) {
  using namespace echomap;
  std::filesystem::path json;
  std::uint64_t steps = 10'000'000;
  std::uint32_t seed = 1;
  CLI::App app("The firmware's outputs on AVR, ARM and this machine, step by step");
  app.add_option("--steps", steps, "Milliseconds of the robot's life, on each target")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--seed", seed, "First seed; one for every 50,000 steps")->capture_default_str();
  app.add_option("--json", json, "Write the figures to this file");
  CLI11_PARSE(app, argc, argv);
  const auto result = tests::compare_targets(steps, seed);
  for (const auto& difference : result.differences) {
    fmt::print("{}\n", difference);
  }
  const std::size_t targets = tests::DifferentialTarget::all().size();
  bench::report({{"differential_targets", double(targets), "", 1, {}},
                 {"differential_mismatches", double(result.mismatches), "", result.steps, {}}},
                json);
  return result.mismatches == 0 ? 0 : 1;
}
