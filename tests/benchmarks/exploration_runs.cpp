// SPDX-License-Identifier: MIT
#include "tests/benchmarks/exploration_runs.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <future>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/exports/trajectory_tum.hpp"
#include "host/files/atomic_file.hpp"
#include "host/session/child_process.hpp"
#include "host/session/temporary_folder.hpp"
#include "host/strategies/strategy_setup.hpp"
#include "tests/benchmarks/exploration_log.hpp"

namespace echomap::bench {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::minutes kPatience(15);

std::vector<std::string> command_of(const ExplorationCase& what, int seed, const fs::path& run) {
  std::vector<std::string> command{session::program_folder() / "echomap",
                                   "demo",
                                   "--headless",
                                   "--no-kidnap",
                                   "--out=" + run.string(),
                                   "--json=" + run.string() + ".json"};
  strategies::StrategyOptions strategy;
  strategy.name = what.strategy;
  if (strategies::limit_of(strategy) == strategies::StrategyLimit::kStops) {
    command.emplace_back("--stops=60");
  }
  const auto arguments = tests::demo_arguments(what, seed);
  command.insert(command.end(), arguments.begin(), arguments.end());
  return command;
}

template <class Value>
std::optional<Value> value_or_none(const nlohmann::json& report, const char* name) {
  const auto& value = report.at(name);
  return value.is_number() ? std::optional(value.get<Value>()) : std::nullopt;
}

void add_true_path(const fs::path& trajectory, ExplorationRun& run) {
  const auto poses = exports::read_trajectory_tum(trajectory);
  for (const auto& pose : poses) {
    const double off_m =
        (pose.T_map_robot.position_m() - poses.front().T_map_robot.position_m()).norm();
    run.end_off_start_m = off_m;
    run.max_distance_from_start_m = std::max(run.max_distance_from_start_m, off_m);
  }
}

ExplorationRun run_of(const nlohmann::json& report, const nlohmann::json& truth) {
  ExplorationRun run;
  run.outcome = report.at("outcome").get<std::string>();
  run.complete = run.outcome == "complete" || run.outcome == "no-new-ground";
  run.free_iou = report.at("free_iou").get<double>();
  run.wall_rmse_m = value_or_none<double>(report, "wall_rmse_m");
  run.wall_recall = report.at("wall_recall").get<double>();
  run.sim_seconds = report.at("sim_seconds").get<double>();
  run.distance_m = report.at("travelled_m").get<double>();
  run.bumps = truth.at("bumps").get<int>();
  run.hard_collisions = truth.at("hard_collisions").get<int>();
  run.corners = report.at("outline_corners").get<std::size_t>();
  run.room_corners = report.at("room_corners").get<std::size_t>();
  run.corner_rmse_m = value_or_none<double>(report, "corner_rmse_m");
  run.phases = value_or_none<std::size_t>(report, "phases");
  run.phases_reached = value_or_none<std::size_t>(report, "phases_reached");
  return run;
}

void complain(const ExplorationCase& what, int seed, const std::string& of) {
  fmt::print(stderr, "{} in {}, seed {}, {}\n", what.strategy, what.room, seed, of);
}

std::optional<ExplorationRun> explore_once(const ExplorationCase& what,
                                           int seed,
                                           const fs::path& folder) {
  const fs::path run = folder / std::to_string(seed);
  const std::string log = run.string() + ".log";
  session::ChildProcess demo(command_of(what, seed, run), log);
  const auto code = demo.wait_for(kPatience);
  const std::string report = run.string() + ".json";
  if (!code || !fs::exists(report)) {
    complain(what, seed, "did not end by itself:\n" + files::read_text_file(log));
    return std::nullopt;
  }
  const auto scored = nlohmann::json::parse(files::read_text_file(report));
  if (!scored.contains("free_iou")) {
    complain(what, seed, "has no score:\n" + files::read_text_file(log));
    return std::nullopt;
  }
  auto came_to =
      run_of(scored, nlohmann::json::parse(files::read_text_file(run / "truth/truth.json")));
  add_true_path(run / "truth/truth.tum", came_to);
  return came_to;
}

}  // namespace

std::vector<ExplorationRun> explore_seeds(const ExplorationCase& what,
                                          const SeedRange& seeds,
                                          ExplorationLog& log) {
  const session::TemporaryFolder folder;
  std::vector<std::optional<ExplorationRun>> by_seed(static_cast<std::size_t>(seeds.count));
  std::atomic<int> next{0};
  const auto work = [&] {
    for (int i = next++; i < seeds.count; i = next++) {
      const int seed = seeds.first + i;
      auto& run = by_seed[static_cast<std::size_t>(i)];
      run = log.find(what, seed);
      if (!run && (run = explore_once(what, seed, folder.path()))) {
        log.add(what, seed, *run);
      }
    }
  };
  std::vector<std::future<void>> workers;
  for (int job = 0; job < seeds.jobs; ++job) {
    workers.push_back(std::async(std::launch::async, work));
  }
  for (auto& worker : workers) {
    worker.get();
  }
  std::vector<ExplorationRun> runs;
  for (auto& run : by_seed) {
    if (run) {
      runs.push_back(*std::move(run));
    }
  }
  return runs;
}

}  // namespace echomap::bench
