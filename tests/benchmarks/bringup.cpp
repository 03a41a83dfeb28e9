// SPDX-License-Identifier: MIT
// The demo over many seeds: medians of its scores, and how many of the runs ended by themselves.
#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/apps/child_process.hpp"
#include "host/files/atomic_file.hpp"
#include "tests/benchmarks/figures.hpp"

namespace echomap::bench {
namespace {

struct Options {
  int seeds = 20;
  std::string world = "living_room";
  std::string robot = "uno_2wd";
  std::string emulator = "simavr";
  std::filesystem::path json;
};

constexpr std::chrono::minutes kPatience(5);

/// The report of one demo; empty where it did not end by itself.
std::optional<nlohmann::json> run_demo(const Options& options,
                                       int seed,
                                       const std::filesystem::path& folder) {
  const auto report = folder / "report.json";
  apps::ChildProcess demo({apps::program_folder() / "echomap",
                           "demo",
                           "--headless",
                           "--world=" + options.world,
                           "--robot=" + options.robot,
                           "--emulator=" + options.emulator,
                           "--seed=" + std::to_string(seed),
                           "--out=" + (folder / std::to_string(seed)).string(),
                           "--json=" + report.string()},
                          folder / "log");
  if (demo.wait_for(kPatience) != 0) {
    return std::nullopt;
  }
  return nlohmann::json::parse(files::read_text_file(report));
}

void run(const Options& options) {
  struct Column {
    const char* name;
    const char* unit;
    std::vector<double> values{};
  };
  std::vector<Column> columns{{"free_iou", ""},
                              {"wall_rmse_m", "m"},
                              {"wall_recall", ""},
                              {"ate_rmse_m", "m"},
                              {"sim_seconds", "s"},
                              {"wall_seconds", "s"},
                              {"stops", ""}};
  const auto folder = std::filesystem::temp_directory_path() / "echomap-bench-bringup";
  std::filesystem::create_directories(folder);
  double complete = 0.0;
  for (int seed = 1; seed <= options.seeds; ++seed) {
    const auto report = run_demo(options, seed, folder);
    if (!report) {
      fmt::print(stderr, "seed {} did not end by itself\n", seed);
      continue;
    }
    ++complete;
    for (Column& column : columns) {
      const auto& value = report->at(column.name);
      if (value.is_number()) {
        column.values.push_back(value.get<double>());
      }
    }
  }
  std::vector<Figure> figures{{"runs_complete", complete, "", std::size_t(options.seeds), {}}};
  for (const Column& column : columns) {
    if (!column.values.empty()) {
      figures.push_back(
          {column.name, median(column.values), column.unit, column.values.size(), {}});
    }
  }
  report(figures, options.json);
}

}  // namespace
}  // namespace echomap::bench

int main(int argc, char** argv) {
  echomap::bench::Options options;
  CLI::App app("Medians of the demo's scores over many seeds");
  app.add_option("--seeds", options.seeds, "Run seeds 1 to this")->capture_default_str();
  app.add_option("--world", options.world)->capture_default_str();
  app.add_option("--robot", options.robot)->capture_default_str();
  app.add_option("--emulator", options.emulator)->capture_default_str();
  app.add_option("--json", options.json, "Write the figures to this file");
  CLI11_PARSE(app, argc, argv);
  echomap::bench::run(options);
}
