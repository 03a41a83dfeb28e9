// SPDX-License-Identifier: MIT
#include "tests/benchmarks/demo_runs.hpp"

#include <array>
#include <atomic>
#include <chrono>
#include <exception>
#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <thread>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/console/exit_code.hpp"
#include "host/files/atomic_file.hpp"
#include "host/session/child_process.hpp"
#include "host/session/temporary_folder.hpp"
#include "tests/support/median.hpp"

namespace echomap::bench {
namespace {

/// Beside others, on an emulator that is slower than the robot.
constexpr std::chrono::minutes kPatience(15);

/// A figure of the demo's report, and what `--check` demands of its median.
struct Column {
  const char* name;
  const char* unit;
  std::optional<double> least{};
  std::optional<double> most{};
};

constexpr std::array<Column, 7> kColumns{{{"free_iou", "", 0.85},
                                          {"wall_rmse_m", "m", {}, 0.06},
                                          {"wall_recall", ""},
                                          {"ate_rmse_m", "m"},
                                          {"sim_seconds", "s"},
                                          {"wall_seconds", "s"},
                                          {"stops", ""}}};

/// Where the map or the robot's place in it is not what was asked for, it has ended, too.
bool has_ended_by_itself(const std::optional<int>& status) {
  return status == static_cast<int>(console::ExitCode::kOk) ||
         status == static_cast<int>(console::ExitCode::kUnfinished);
}

/// The report of one demo; empty where it did not end by itself or has no score.
std::optional<nlohmann::json> run_demo(const DemoRuns& options,
                                       int seed,
                                       const std::filesystem::path& folder) {
  const auto run = folder / std::to_string(seed);
  const auto report = run.string() + ".json";
  const auto log = run.string() + ".log";
  std::vector<std::string> command{
      options.program.empty() ? session::program_folder() / "echomap" : options.program,
      "demo",
      "--headless",
      "--world=" + options.world,
      "--robot=" + options.robot,
      options.board.empty() ? "--emulator=" + options.emulator : "--board=" + options.board,
      "--line=" + options.line,
      "--seed=" + std::to_string(seed),
      "--out=" + run.string(),
      "--json=" + report};
  if (!options.faults.empty()) {
    command.push_back("--faults=" + options.faults);
  }
  if (!options.driver.empty()) {
    command.push_back("--driver=" + options.driver);
  }
  session::ChildProcess demo(command, log);
  if (!has_ended_by_itself(demo.wait_for(kPatience))) {
    fmt::print(stderr, "seed {} did not end by itself:\n{}\n", seed, files::read_text_file(log));
    return std::nullopt;
  }
  return nlohmann::json::parse(files::read_text_file(report));
}

/// The same where something keeps it from running or its report from being read, whose words go to
/// stderr: an exception that leaves a thread would end all runs.
std::optional<nlohmann::json> try_demo(const DemoRuns& options,
                                       int seed,
                                       const std::filesystem::path& folder) {
  try {
    return run_demo(options, seed, folder);
  } catch (const std::exception& error) {
    fmt::print(stderr, "seed {} did not end by itself: {}\n", seed, error.what());
    return std::nullopt;
  }
}

using Values = std::map<std::string, std::vector<double>>;

/// Adds what the report of a run says of each column.
void take(const nlohmann::json& report, Values& values) {
  for (const Column& column : kColumns) {
    if (const auto& value = report.at(column.name); value.is_number()) {
      values[column.name].push_back(value.get<double>());
    }
  }
}

/// The reports of all seeds, in their order.
std::vector<std::optional<nlohmann::json>> run_demos(const DemoRuns& options) {
  const session::TemporaryFolder folder;
  std::vector<std::optional<nlohmann::json>> reports(static_cast<std::size_t>(options.seeds));
  std::atomic<int> next_seed = 1;
  const auto work = [&] {
    for (int seed = next_seed++; seed <= options.seeds; seed = next_seed++) {
      reports[static_cast<std::size_t>(seed - 1)] = try_demo(options, seed, folder.path());
    }
  };
  std::vector<std::jthread> workers;
  for (int i = 0; i < options.jobs; ++i) {
    workers.emplace_back(work);
  }
  workers.clear();
  return reports;
}

}  // namespace

DemoFigures measure_demos(const DemoRuns& options) {
  DemoFigures demos;
  Values values;
  double ended = 0.0;
  double finished = 0.0;
  double complete = 0.0;
  double relocalized = 0.0;
  for (const auto& report : run_demos(options)) {
    if (report) {
      ended += 1.0;
      finished += report->at("finished").get<bool>() ? 1.0 : 0.0;
      complete += report->at("outcome") == "complete" ? 1.0 : 0.0;
      relocalized += report->contains("kidnap") && report->at("kidnap").at("found") ? 1.0 : 0.0;
      demos.emulator = report->at("emulator").get<std::string>();
      take(*report, values);
    }
  }
  const auto runs = static_cast<std::size_t>(options.seeds);
  demos.figures = {{"runs_ended", ended, "", runs, {}},
                   {"runs_finished", finished, "", runs, {}},
                   {"runs_complete", complete, "", runs, {}},
                   {"relocalized", relocalized, "", runs, {}}};
  for (const Column& column : kColumns) {
    if (const auto& list = values[column.name]; !list.empty()) {
      demos.figures.push_back({column.name, tests::median(list), column.unit, list.size(), {}});
    }
  }
  return demos;
}

bool demos_pass(const std::vector<Figure>& figures, double seeds) {
  bool passed = true;
  const auto check = [&](const char* name, double runs, double least, double most) {
    for (const Figure& figure : figures) {
      if (figure.name == name && figure.value >= least && figure.value <= most &&
          static_cast<double>(figure.runs) == runs) {
        return;
      }
    }
    fmt::print(stderr, "{} is not within {} .. {} over {} runs\n", name, least, most, runs);
    passed = false;
  };
  constexpr double kUnbounded = std::numeric_limits<double>::infinity();
  check("runs_finished", seeds, seeds, seeds);
  for (const Column& column : kColumns) {
    if (column.least || column.most) {
      check(
          column.name, seeds, column.least.value_or(-kUnbounded), column.most.value_or(kUnbounded));
    }
  }
  return passed;
}

}  // namespace echomap::bench
