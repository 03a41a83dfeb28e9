// SPDX-License-Identifier: MIT
#include "tests/benchmarks/truth_runs.hpp"

#include <chrono>
#include <exception>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/files/atomic_file.hpp"
#include "host/session/child_process.hpp"

namespace echomap::bench {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::minutes kPatience(30);
/// "Rooms up to 4 x 4 m", with walls drawn a little outside of it.
constexpr double kSmallRoomM = 4.05;

/// Whether the program ended by itself; what it printed is in `log`.
bool has_ended(const std::vector<std::string>& command, const fs::path& log) {
  session::ChildProcess program(command, log);
  return program.wait_for(kPatience).has_value();
}

bool replays_equal(const fs::path& folder) {
  const bool ended = has_ended({session::program_folder() / "echomap",
                                "replay",
                                (folder / "run").string(),
                                "--out=" + (folder / "replay").string(),
                                "--force"},
                               folder / "replay.log");
  return ended && fs::exists(folder / "replay/map.pgm") &&
         files::read_text_file(folder / "run/map.pgm") ==
             files::read_text_file(folder / "replay/map.pgm");
}

TruthRun run_of(const TruthRobot& robot, const fs::path& folder) {
  const auto report = nlohmann::json::parse(files::read_text_file(folder / "report.json"));
  const auto truth = nlohmann::json::parse(files::read_text_file(folder / "run/truth/truth.json"));
  TruthRun run;
  run.outcome = report.at("outcome").get<std::string>();
  run.complete = run.outcome == "complete";
  run.finished = report.at("finished").get<bool>();
  run.coverage = report.at("coverage").at("share").get<double>();
  const auto summary = nlohmann::json::parse(files::read_text_file(folder / "run/summary.json"));
  if (!summary.at("expected_wall_rmse_m").is_null()) {
    run.expected_wall_rmse_m = summary.at("expected_wall_rmse_m").get<double>();
    run.wall_rmse_p90_m = summary.at("wall_rmse_p90_m").get<double>();
  }
  run.sim_seconds = report.at("sim_seconds").get<double>();
  run.hard_collisions = truth.at("hard_collisions").get<int>();
  run.bumps = truth.at("bumps").get<int>();
  run.stops = report.at("stops").get<std::size_t>();
  run.score = evaluation::score_run(folder / "run", folder / "run/truth", robot.radius_m);
  run.replays_equal = replays_equal(folder);
  return run;
}

}  // namespace

bool TruthRoom::is_small() const {
  Eigen::Vector2d low_m = plan.room_m().front();
  Eigen::Vector2d high_m = low_m;
  for (const Eigen::Vector2d& corner_m : plan.room_m()) {
    low_m = low_m.cwiseMin(corner_m);
    high_m = high_m.cwiseMax(corner_m);
  }
  return (high_m - low_m).maxCoeff() <= kSmallRoomM;
}

std::vector<std::string> demo_command(const TruthRoom& room,
                                      const TruthRobot& robot,
                                      int seed,
                                      bool is_carried_off,
                                      const fs::path& folder) {
  std::vector<std::string> command{session::program_folder() / "echomap",
                                   "demo",
                                   "--headless",
                                   "--strategy=" + robot.strategy,
                                   "--world=" + room.world,
                                   "--robot=" + robot.profile,
                                   "--emulator=" + room.emulator,
                                   "--seed=" + std::to_string(seed),
                                   "--out=" + (folder / "run").string(),
                                   "--force",
                                   "--json=" + (folder / "report.json").string()};
  if (!is_carried_off) {
    command.emplace_back("--no-kidnap");
  }
  if (!robot.body.empty()) {
    command.push_back("--body=" + robot.body);
  }
  if (!room.stop_list.empty()) {
    command.push_back("--stop-list=" + room.stop_list.string());
  }
  return command;
}

std::optional<TruthRun> run_truth(const TruthRoom& room,
                                  const TruthRobot& robot,
                                  int seed,
                                  const fs::path& folder) {
  fs::create_directories(folder);
  const fs::path log = folder / "demo.log";
  std::string why = "it did not end by itself";
  if (has_ended(demo_command(room, robot, seed, false, folder), log)) {
    try {
      return run_of(robot, folder);
    } catch (const std::exception& error) {
      why = error.what();
    }
  }
  fmt::print(stderr,
             "{}, seed {}, has no score: {}\n{}\n",
             room.name,
             seed,
             why,
             files::read_text_file(log));
  return std::nullopt;
}

}  // namespace echomap::bench
