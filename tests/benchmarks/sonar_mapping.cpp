// SPDX-License-Identifier: MIT
// Sonar maps against the laser's, log by log: public logs with corrected poses, a pan sonar of 24
// directions made from the laser, and the maps of our model and of its peers from the same
// readings.
#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "tests/benchmarks/figures.hpp"
#include "tests/benchmarks/sonar_figures.hpp"
#include "tests/support/real_data.hpp"

namespace echomap::bench {
namespace {

struct Options {
  LaserToSonarParams sonar;
  std::size_t seeds = 3;
  std::vector<std::string> chosen;
  bool blind = false;
  std::filesystem::path json;
};

void say_counts(const std::string& name, const SonarRun& run) {
  fmt::print("{}: {} readings: {} silent, {} behind walls, {} seen through; {} pieces of wall\n",
             name,
             run.counts.readings,
             run.counts.silent,
             run.counts.behind_wall,
             run.counts.seen_through,
             run.wall_pieces);
  fmt::print("{}: wall_recall {:.3f} of the points that answered\n", name, run.recall_bound);
}

void run(const Options& options) {
  std::vector<SonarScores> of_logs;
  std::vector<Figure> figures;
  const auto add = [&](const SonarScores& scores, const std::string& suffix) {
    const auto some = figures_of(scores, options.seeds, suffix);
    figures.insert(figures.end(), some.begin(), some.end());
  };
  for (const auto& [name, path] : options.blind ? blind_sonar_logs() : sonar_logs()) {
    const auto& chosen = options.chosen;
    if (!chosen.empty() && std::find(chosen.begin(), chosen.end(), name) == chosen.end()) {
      continue;
    }
    const auto log = tests::real_data(path);
    if (!std::filesystem::exists(log)) {
      fmt::print("{}: not there, skipped\n", name);
      continue;
    }
    const SonarRun run = run_sonar_log(log, options.sonar, options.seeds);
    say_counts(name, run);
    of_logs.push_back(run.scores);
    add(run.scores, "_" + name);
  }
  if (!of_logs.empty()) {
    add(mean_of(of_logs), "");
  }
  report(figures, options.json);
}

}  // namespace
}  // namespace echomap::bench

int main(int argc, char** argv) {
  echomap::bench::Options options;
  CLI::App app("Sonar maps of public laser logs against the laser's own");
  app.add_option("--seeds", options.seeds, "Medians over so many seeds of the sonar's noise")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  app.add_flag("--blind", options.blind, "The logs that no setting was chosen on");
  app.add_option("--log", options.chosen, "Only these");
  app.add_flag("!--diffuse", options.sonar.specular, "Let every wall answer at any incidence");
  app.add_option("--json", options.json, "Write the figures to this file");
  CLI11_PARSE(app, argc, argv);
  echomap::bench::run(options);
}
