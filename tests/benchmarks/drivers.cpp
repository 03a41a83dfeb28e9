// SPDX-License-Identifier: MIT
// The demo with each kind of motor driver, on the board that it is emulated on.
#include <algorithm>
#include <array>
#include <filesystem>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "tests/benchmarks/demo_runs.hpp"
#include "tests/benchmarks/figures.hpp"

namespace echomap::bench {
namespace {

/// A driver, and which of the four kinds of wires goes to it.
struct Driver {
  const char* name;
  const char* kind;
  const char* board;
};

/// One whose PWM brakes in its pauses and one that coasts where a kind has both; an Uno has no
/// timer left for servos.
constexpr std::array<Driver, 6> kDrivers{{{"phase-enable", "phase_enable", "uno"},
                                          {"tb6612fng", "in1_in2_pwm", "uno"},
                                          {"l298n", "in1_in2_pwm", "uno"},
                                          {"l293d", "in1_in2_pwm", "uno"},
                                          {"drv8833", "two_pwm", "uno"},
                                          {"servo", "servo", "mega"}}};

/// The figures of one driver, under its name.
std::vector<Figure> named(std::vector<Figure> figures, const Driver& driver) {
  for (Figure& figure : figures) {
    figure.name = std::string(driver.name) + "_" + figure.name;
  }
  return figures;
}

/// All drivers' figures, and of how many of the four kinds every driver passes.
std::vector<Figure> measure_drivers(DemoRuns options, const std::vector<std::string>& wanted) {
  std::vector<Figure> all;
  std::set<std::string> kinds;
  std::set<std::string> failed;
  for (const Driver& driver : kDrivers) {
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), driver.name) == wanted.end()) {
      continue;
    }
    fmt::print(stderr, "{} on {}\n", driver.name, driver.board);
    options.driver = driver.name;
    options.board = driver.board;
    const std::vector<Figure> figures = measure_demos(options).figures;
    kinds.insert(driver.kind);
    if (!demos_pass(figures, options.seeds)) {
      failed.insert(driver.kind);
    }
    const std::vector<Figure> with_name = named(figures, driver);
    all.insert(all.end(), with_name.begin(), with_name.end());
  }
  const auto passing = static_cast<double>(kinds.size() - failed.size());
  all.push_back({"driver_kinds_passing", passing, "", kinds.size(), {}});
  return all;
}

}  // namespace
}  // namespace echomap::bench

int main(int argc, char** argv) {
  using namespace echomap::bench;
  DemoRuns options;
  std::filesystem::path json;
  std::vector<std::string> wanted;
  CLI::App app("The demo over many seeds with each kind of motor driver");
  app.add_option("--seeds", options.seeds, "Run seeds 1 to this")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--drivers", wanted, "Only these, with commas between")->delimiter(',');
  app.add_option("--json", json, "Write the figures to this file");
  CLI11_PARSE(app, argc, argv);
  report(measure_drivers(options, wanted), json);
  return 0;
}
