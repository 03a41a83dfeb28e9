// SPDX-License-Identifier: MIT
// What a fleet of robots costs and shows.
#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "tests/benchmarks/figures.hpp"
#include "tests/benchmarks/fleet_load.hpp"
#include "tests/benchmarks/mrclam6_joint.hpp"

namespace echomap::bench {
namespace {

struct FleetOptions {
  std::string part = "all";
  double load_s = 30.0;
  std::filesystem::path json;

  bool has(const char* name) const { return part == "all" || part == name; }
};

std::vector<Figure> fleet_figures(const FleetOptions& options) {
  std::vector<Figure> figures;
  const auto append = [&](const std::vector<Figure>& more) {
    figures.insert(figures.end(), more.begin(), more.end());
  };
  if (options.has("load")) {
    append(load_figures(options.load_s));
  }
  if (options.has("mrclam6")) {
    append(mrclam6_joint_figures(true));
  }
  return figures;
}

}  // namespace
}  // namespace echomap::bench

int main(int argc, char** argv) {
  echomap::bench::FleetOptions options;
  CLI::App app("What a fleet of robots costs and shows");
  app.add_option("--part", options.part, "Only these figures")
      ->check(CLI::IsMember({"all", "load", "mrclam6"}))
      ->capture_default_str();
  app.add_option("--load-s", options.load_s, "Replay so many seconds for each number of robots")
      ->capture_default_str();
  app.add_option("--json", options.json, "Write the figures to this file");
  CLI11_PARSE(app, argc, argv);
  echomap::bench::report(echomap::bench::fleet_figures(options), options.json);
}
