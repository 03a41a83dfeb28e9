// SPDX-License-Identifier: MIT
#include "tests/benchmarks/team_runs.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <exception>
#include <iterator>
#include <limits>
#include <thread>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/evaluation/truth_directory.hpp"
#include "host/files/atomic_file.hpp"
#include "host/geometry/angle.hpp"
#include "host/session/child_process.hpp"
#include "tests/benchmarks/ideal_team.hpp"

namespace echomap::bench {
namespace {

namespace fs = std::filesystem;
using geometry::Pose2;
using nlohmann::json;

/// Larger ones have bounds of their own.
constexpr const char* kLargeWorld = "ward";
constexpr const char* kCost = "cost.json";

bool is_made(const fs::path& folder) {
  return fs::exists(folder / "summary.json") || fs::exists(folder / kCost);
}

std::string words_of(const Pose2& T_world_start) {
  return fmt::format("{:.6f},{:.6f},{:.4f}",
                     T_world_start.x_m(),
                     T_world_start.y_m(),
                     geometry::degrees(T_world_start.heading_rad()));
}

std::vector<std::string> command_of(const TeamRuns& runs,
                                    const TeamCase& what,
                                    const std::string& starts,
                                    const fs::path& folder) {
  std::vector<std::string> command{
      runs.program.empty() ? session::program_folder() / "echomap" : runs.program,
      "fleet",
      "start",
      "--robots=" + std::to_string(what.robots),
      "--world=" + what.world,
      "--headless",
      "--seed=" + std::to_string(what.seed),
      "--emulator=" + runs.emulator,
      "--out=" + folder.string(),
      "--force"};
  if (!starts.empty()) {
    command.push_back("--starts=" + starts);
  }
  return command;
}

/// Unless it is there already.
void make_run(const TeamRuns& runs,
              const TeamCase& what,
              const std::string& starts,
              const fs::path& folder) {
  if (is_made(folder)) {
    return;
  }
  fs::create_directories(folder);
  const auto begin = std::chrono::steady_clock::now();
  session::ChildProcess fleet(command_of(runs, what, starts, folder), folder / "fleet.log");
  const auto exit = fleet.wait_for(std::chrono::minutes(runs.patience_min));
  if (!exit) {
    // Its robots save what they have, so that its row says how far they came.
    fleet.send(SIGTERM);
    fleet.wait_for(std::chrono::minutes(1));
  }
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
  const json cost{
      {"exit", exit ? json(*exit) : json()}, {"wall_s", wall.count()}, {"cpu_s", fleet.cpu_s()}};
  files::write_text_file(folder / kCost, cost.dump() + "\n");
}

std::optional<double> number(const json& value) {
  return value.is_number() ? std::optional(value.get<double>()) : std::nullopt;
}

/// Where each robot began, and what it ran into.
void read_truths(const fs::path& folder, TeamRun& run) {
  for (std::size_t i = 0; i < run.what.robots; ++i) {
    const fs::path truth =
        run.what.robots == 1 ? folder / "truth" : folder / "truth" / fmt::format("robot{}", i);
    const auto path = evaluation::read_truth(truth).trajectory;
    if (!path.empty()) {
      run.T_world_starts.push_back(path.front().T_world_robot);
    }
    const auto told = json::parse(files::read_text_file(truth / "truth.json"));
    run.bumps += told.at("bumps").get<int>();
    run.hard_collisions += told.at("hard_collisions").get<int>();
  }
}

void read_robots(const json& fleet, TeamRun& run) {
  const auto& robots = fleet.at("robots");
  for (const json& robot : robots) {
    const auto& outcome = robot.at("outcome");
    const auto& exit = fleet.at("exits").at(robot.at("robot").get<std::string>());
    run.endings.push_back(fmt::format("{} {} {}",
                                      robot.at("robot").get<std::string>(),
                                      exit.is_null() ? "-" : exit.dump(),
                                      outcome.is_string() ? outcome.get<std::string>() : "-"));
    run.sim_seconds = std::max(run.sim_seconds, number(robot.at("sim_seconds")).value_or(0.0));
    if (const auto& met = robot.at("encounters"); !met.is_null()) {
      run.deadlocks += met.at("deadlocks").get<std::size_t>();
      run.deadlocks_left += met.at("ended_in_deadlock").get<bool>() ? 1U : 0U;
    }
    const auto& error = robot.at("relative_pose_error");
    if (error.is_null() || &robot == &robots[0]) {
      continue;
    }
    const double off_m = error.at("position_m").get<double>();
    const double off_rad = error.at("heading_rad").get<double>();
    const double beyond_m = off_m - error.at("own_errors_m").get<double>();
    run.pose_error_m = std::max(run.pose_error_m.value_or(0.0), off_m);
    run.heading_error_rad = std::max(run.heading_error_rad.value_or(0.0), off_rad);
    run.beyond_own_m = std::max(run.beyond_own_m.value_or(beyond_m), beyond_m);
  }
}

void read_summary(const json& summary, TeamRun& run) {
  run.outcome = summary.at("outcome").get<std::string>();
  const json& fleet = summary.at("fleet");
  if (!fleet.contains("robots")) {
    return;
  }
  read_robots(fleet, run);
  if (const json& course = fleet.at("course"); !course.is_null()) {
    run.joined_s = number(course.at("joined_s"));
    run.wrong_joins = course.at("wrong_joins").get<std::size_t>();
    run.wrong_joins_left = course.at("wrong_joins_left").get<std::size_t>();
    run.floor_90_s = number(course.at("floor_90_s"));
    run.floor_seen = course.at("floor_seen").get<double>();
  }
  if (const auto bytes = number(fleet.at("bytes_per_s_per_robot"))) {
    run.kbytes_per_s_per_robot = 1e-3 * *bytes;
  }
  if (const json& map = fleet.at("map"); !map.is_null()) {
    run.free_iou = number(map.at("free_iou"));
    run.solid_called_free = number(map.at("solid_called_free"));
  }
}

/// By the floor of its truth.
std::optional<double> ideal_ratio(const TeamRun& team, const fs::path& folder) {
  const auto truth = evaluation::read_truth(folder / "truth" / "robot0");
  std::vector<Eigen::Vector2d> starts_m;
  for (const Pose2& T_world_start : team.T_world_starts) {
    starts_m.push_back(T_world_start.position_m());
  }
  if (starts_m.size() != team.what.robots) {
    return std::nullopt;
  }
  const auto team_s = ideal_team_s(truth.map.cells, starts_m);
  const auto alone_s = ideal_team_s(truth.map.cells, {starts_m.front()});
  return team_s && alone_s ? std::optional(*team_s / *alone_s) : std::nullopt;
}

/// What each says when it has ended.
void say(const TeamRun& run) {
  fmt::print(stderr,
             "{} {} robots seed {}: {} joined {} floor {:.2f} at {:.0f} s\n",
             run.what.world,
             run.what.robots,
             run.what.seed,
             run.outcome.empty() ? "nothing told" : run.outcome,
             run.joined_s ? fmt::format("{:.0f} s", *run.joined_s) : "never",
             run.floor_seen,
             run.floor_90_s.value_or(std::numeric_limits<double>::quiet_NaN()));
}

TeamPair run_pair(const TeamRuns& runs, const TeamCase& what) {
  const fs::path folder = runs.folder / fmt::format("{}_{}_{}", what.world, what.robots, what.seed);
  TeamPair pair;
  pair.team.what = what;
  pair.alone.what = {what.world, 1, what.seed};
  make_run(runs, what, runs.starts, folder);
  pair.team = read_team_run(what, folder);
  say(pair.team);
  if (pair.team.T_world_starts.empty()) {
    return pair;
  }
  const std::string start = words_of(pair.team.T_world_starts.front());
  // Of teams of two and four that begin alike there is one.
  const fs::path alone = runs.folder / fmt::format("{}_1_{}_{}", what.world, what.seed, start);
  make_run(runs, pair.alone.what, start, alone);
  pair.alone = read_team_run(pair.alone.what, alone);
  say(pair.alone);
  if (what.world != kLargeWorld) {
    pair.ideal_ratio = ideal_ratio(pair.team, folder);
  }
  return pair;
}

/// The same where something keeps it from running: an exception that leaves a thread would end all.
TeamPair try_pair(const TeamRuns& runs, const TeamCase& what) {
  try {
    return run_pair(runs, what);
  } catch (const std::exception& error) {
    fmt::print(
        stderr, "{} {} robots seed {}: {}\n", what.world, what.robots, what.seed, error.what());
    TeamPair pair;
    pair.team.what = what;
    pair.alone.what = {what.world, 1, what.seed};
    return pair;
  }
}

}  // namespace

std::optional<double> TeamPair::time_ratio() const {
  if (!alone.floor_90_s) {
    return std::nullopt;
  }
  return team.floor_90_s ? *team.floor_90_s / *alone.floor_90_s
                         : std::numeric_limits<double>::infinity();
}

TeamRun read_team_run(const TeamCase& what, const fs::path& folder) {
  TeamRun run;
  run.what = what;
  try {
    if (fs::exists(folder / kCost)) {
      const auto cost = json::parse(files::read_text_file(folder / kCost));
      if (!cost.at("exit").is_null()) {
        run.exit = cost.at("exit").get<int>();
      }
      run.wall_s = cost.at("wall_s").get<double>();
      run.cpu_s = cost.at("cpu_s").get<double>();
    }
    read_truths(folder, run);
    read_summary(json::parse(files::read_text_file(folder / "summary.json")), run);
    // Of a run that was made for itself, nobody has kept what it cost.
    if (!run.exit && run.outcome == "complete") {
      run.exit = 0;
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}: {}\n", folder.string(), error.what());
  }
  return run;
}

std::vector<TeamPair> run_teams(const TeamRuns& runs) {
  // By seed, so that what is there early says something of each world. Teams of several sizes may
  // have one single robot: they are made one after the other.
  struct Place {
    std::string world;
    int seed = 0;
    std::vector<TeamPair> pairs{};
  };
  std::vector<Place> places;
  for (int seed = runs.first_seed; seed <= runs.last_seed; ++seed) {
    for (const std::string& world : runs.worlds) {
      places.push_back({world, seed});
    }
  }
  std::atomic<std::size_t> next = 0;
  std::vector<std::jthread> workers;
  for (int job = 0; job < runs.jobs; ++job) {
    workers.emplace_back([&] {
      for (std::size_t i = next++; i < places.size(); i = next++) {
        for (const std::size_t robots : runs.robots) {
          places[i].pairs.push_back(try_pair(runs, {places[i].world, robots, places[i].seed}));
        }
      }
    });
  }
  workers.clear();
  std::vector<TeamPair> pairs;
  for (Place& place : places) {
    std::ranges::move(place.pairs, std::back_inserter(pairs));
  }
  return pairs;
}

}  // namespace echomap::bench
