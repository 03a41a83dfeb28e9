// SPDX-License-Identifier: MIT
// What a fleet of robots costs and shows.
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "host/files/atomic_file.hpp"
#include "host/session/child_process.hpp"
#include "host/session/temporary_folder.hpp"
#include "tests/benchmarks/exchange_figures.hpp"
#include "tests/benchmarks/figures.hpp"
#include "tests/benchmarks/fleet_load.hpp"
#include "tests/benchmarks/fleet_record.hpp"
#include "tests/benchmarks/mrclam6_joint.hpp"
#include "tests/benchmarks/source_figures.hpp"
#include "tests/benchmarks/team_figures.hpp"
#include "tests/benchmarks/team_runs.hpp"

namespace echomap::bench {
namespace {

struct FleetOptions {
  std::string part = "all";
  TeamRuns teams;
  std::filesystem::path table;
  std::uint32_t exchange_seeds = 40;
  std::uint32_t source_seeds = 40;
  double load_s = 30.0;
  std::filesystem::path record;
  std::filesystem::path json;

  bool has(const char* name) const { return part == "all" || part == name; }
};

std::vector<Figure> teams(const FleetOptions& options) {
  const auto pairs = run_teams(options.teams);
  const std::string table = to_markdown(team_table(pairs));
  fmt::print("{}\n", table);
  if (!options.table.empty()) {
    files::write_text_file(options.table, table);
  }
  return team_figures(pairs);
}

std::vector<Figure> load(const FleetOptions& options) {
  const session::TemporaryFolder folder;
  const auto record = options.record.empty() ? record_a_fleet(folder.path()) : options.record;
  return load_figures(read_fleet_record(record), options.load_s);
}

std::vector<Figure> fleet_figures(const FleetOptions& options) {
  std::vector<Figure> figures;
  const auto append = [&](const std::vector<Figure>& more) {
    figures.insert(figures.end(), more.begin(), more.end());
  };
  if (options.has("load")) {
    append(load(options));
  }
  if (options.has("mrclam6")) {
    append(mrclam6_joint_figures(true));
  }
  if (options.has("exchange")) {
    append(exchange_figures(options.exchange_seeds));
  }
  if (options.has("source")) {
    append(source_figures(options.source_seeds));
  }
  if (options.has("teams")) {
    append(teams(options));
  }
  return figures;
}

void add_team_options(CLI::App& app, FleetOptions& options) {
  TeamRuns& runs = options.teams;
  runs.folder = session::program_folder() / "fleet_runs";
  app.add_option("--worlds", runs.worlds, "Worlds of the teams")
      ->delimiter(',')
      ->capture_default_str();
  app.add_option("--robots", runs.robots, "Numbers of robots")
      ->delimiter(',')
      ->check(CLI::Range(1, 16))
      ->capture_default_str();
  app.add_option("--first", runs.first_seed, "First seed of the teams")->capture_default_str();
  app.add_option("--last", runs.last_seed, "Last seed of the teams")->capture_default_str();
  app.add_option("--emulator", runs.emulator, "What runs the firmware")
      ->check(CLI::IsMember({"simavr", "mock"}))
      ->capture_default_str();
  app.add_option("--starts",
                 runs.starts,
                 "As `echomap fleet start` takes it; empty: the first robot at the world's start")
      ->capture_default_str();
  app.add_option("--jobs", runs.jobs, "Fleets that run at a time")
      ->check(CLI::Range(1, 2))
      ->capture_default_str();
  app.add_option("--patience-min", runs.patience_min, "A run that takes longer has not ended")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--runs", runs.folder, "Folder of the runs; those that are there are not repeated")
      ->capture_default_str();
  app.add_option("--table", options.table, "Write the table of the runs to this file");
}

}  // namespace
}  // namespace echomap::bench

int main(int argc, char** argv) {
  echomap::bench::FleetOptions options;
  CLI::App app("What a fleet of robots costs and shows");
  app.add_option("--part", options.part, "Only these figures")
      ->check(CLI::IsMember({"all", "exchange", "load", "mrclam6", "source", "teams"}))
      ->capture_default_str();
  echomap::bench::add_team_options(app, options);
  app.add_option("--exchange-seeds", options.exchange_seeds, "Fleets to which things happen")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--source-seeds", options.source_seeds, "Searches of a source per world")
      ->check(CLI::Range(4, 10000))
      ->capture_default_str();
  app.add_option("--load-s", options.load_s, "Replay so many seconds for each number of robots")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--record",
                 options.record,
                 "Replay the robots of this file of `echomap fleet record`; empty: of two that are "
                 "recorded first")
      ->check(CLI::ExistingFile);
  app.add_option("--json", options.json, "Write the figures to this file");
  CLI11_PARSE(app, argc, argv);
  echomap::bench::report(echomap::bench::fleet_figures(options), options.json);
}
