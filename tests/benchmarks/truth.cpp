// SPDX-License-Identifier: MIT
// Whether a map tells the truth: what is solid, what is floor and where a robot can go, in rooms
// that are toured by a list of stops, over many seeds, beside the best map of the same stops.
#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "host/files/atomic_file.hpp"
#include "host/session/robot_profile.hpp"
#include "host/session/temporary_folder.hpp"
#include "host/strategies/strategy_setup.hpp"
#include "tests/benchmarks/covering_tour.hpp"
#include "tests/benchmarks/figures.hpp"
#include "tests/benchmarks/ideal_map.hpp"
#include "tests/benchmarks/markdown_table.hpp"
#include "tests/benchmarks/stop_time.hpp"
#include "tests/benchmarks/truth_figures.hpp"
#include "tests/benchmarks/truth_rooms.hpp"
#include "tests/benchmarks/truth_runs.hpp"

namespace echomap::bench {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::string part = "all";
  int seeds = 20;
  int first_seed = 1;
  int jobs = 2;
  std::vector<std::string> rooms = truth_room_names();
  TruthEmulators emulators;
  TruthRobot robot;
  std::string rough_body = "uno_2wd_rough";
  std::size_t timed_stops = 1000;
  fs::path keep;
  fs::path json;
  fs::path markdown;
  bool check = false;

  bool has(const char* name) const { return part == "all" || part == name; }
};

/// What the issue asks of `--json`.
std::vector<std::string> required_figures(const Options& options) {
  return {"solid_called_free",
          "solid_called_free_worst",
          "objects_found",
          "path_collision_share",
          "free_iou_small",
          "free_iou_all",
          "wall_rmse_small_m",
          "wall_rmse_all_m",
          "wall_recall",
          "rough_fit_deg",
          "live_equals_replay_of_320",
          fmt::format("stop_ms_at_{}", options.timed_stops)};
}

TruthRoom room_of(const Options& options, const std::string& world, const fs::path& folder) {
  TruthRoom room = truth_room(world, options.emulators);
  if (options.robot.strategy == "stops") {
    CoveringTourParams params;
    params.robot_radius_m = options.robot.radius_m;
    const CoveringTour tour = covering_tour(room.plan, params);
    room.stops_m = tour.stops_m;
    room.stop_list = folder / (room.name + "_stops.toml");
    write_stop_list(room.stop_list, tour.places);
  }
  return room;
}

evaluation::PlacedScore ideal_score(const TruthRoom& room, double robot_radius_m) {
  const evaluation::MapTruth truth = truth_of(room.plan);
  const auto map = ideal_map(room.plan, truth, room.stops_m);
  const geometry::Pose2& T_world_map = room.plan.T_world_start();
  return {evaluation::score_map(map, T_world_map, truth),
          evaluation::score_obstacles(map, T_world_map, truth),
          evaluation::score_paths(map, T_world_map, truth, robot_radius_m),
          {}};
}

/// A run that is still to be made.
struct Task {
  std::size_t room = 0;
  int seed = 0;
  bool is_rough = false;
};

std::vector<Task> tasks_of(const Options& options, std::size_t rooms) {
  std::vector<Task> tasks;
  for (std::size_t room = 0; room < rooms; ++room) {
    for (int seed = options.first_seed; seed < options.first_seed + options.seeds; ++seed) {
      tasks.push_back({room, seed, false});
      if (!options.rough_body.empty()) {
        tasks.push_back({room, seed, true});
      }
    }
  }
  return tasks;
}

void print_run(const TruthRoom& room, const Task& task, const TruthRun& run) {
  const auto& score = run.score.start;
  fmt::print(stderr,
             "{:14} seed {:3}{} {}: {} stops, {} bumps, free_iou {:.3f}, fitted {:.3f}, {}\n",
             room.name,
             task.seed,
             task.is_rough ? " rough" : "",
             run.outcome,
             run.stops,
             run.bumps,
             score.map.free_iou,
             run.score.fitted.map.free_iou,
             run.replays_equal ? "replays equal" : "REPLAY DIFFERS");
}

std::optional<TruthRun> carry_out(const Options& options,
                                  TruthRoom room,
                                  const Task& task,
                                  const fs::path& folder) {
  TruthRobot robot = options.robot;
  if (task.is_rough) {
    robot.body = options.rough_body;
    room.emulator = options.emulators.emulator == "mixed" ? "mock" : options.emulators.emulator;
  }
  const fs::path place =
      folder / fmt::format("{}{}_{}", room.name, task.is_rough ? "_rough" : "", task.seed);
  const auto run = run_truth(room, robot, task.seed, place);
  if (options.keep.empty()) {
    fs::remove_all(place);
  }
  if (run) {
    print_run(room, task, *run);
  }
  return run;
}

/// Makes all runs, as many at a time as there are jobs, and puts them where they belong.
void measure_runs(const Options& options,
                  const std::vector<TruthRoom>& rooms,
                  const fs::path& folder,
                  std::vector<TruthCell>& cells) {
  const std::vector<Task> tasks = tasks_of(options, rooms.size());
  std::vector<std::optional<TruthRun>> runs(tasks.size());
  for_each_in_jobs(tasks.size(), options.jobs, [&](std::size_t i) {
    runs[i] = carry_out(options, rooms[tasks[i].room], tasks[i], folder);
  });
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    if (runs[i]) {
      TruthCell& cell = cells[tasks[i].room];
      (tasks[i].is_rough ? cell.rough_runs : cell.runs).push_back(*std::move(runs[i]));
    }
  }
}

std::vector<TruthCell> measure(const Options& options, const fs::path& folder) {
  std::vector<TruthRoom> rooms;
  std::vector<TruthCell> cells;
  for (const std::string& world : options.rooms) {
    rooms.push_back(room_of(options, world, folder));
    const TruthRoom& room = rooms.back();
    TruthCell& cell = cells.emplace_back();
    cell.room = room.name;
    cell.is_small = room.is_small();
    cell.stops = room.stops_m.size();
    if (options.has("ideal") && !room.stops_m.empty()) {
      cell.ideal = ideal_score(room, options.robot.radius_m);
    }
  }
  if (options.has("runs")) {
    measure_runs(options, rooms, folder, cells);
  }
  return cells;
}

bool has_all_figures(const Options& options, const std::vector<Figure>& figures) {
  bool has_all = true;
  for (const std::string& name : required_figures(options)) {
    const bool is_there = std::any_of(figures.begin(), figures.end(), [&](const Figure& figure) {
      return figure.name == name && std::isfinite(figure.value);
    });
    if (!is_there) {
      fmt::print(stderr, "the figure {} is missing\n", name);
      has_all = false;
    }
  }
  return has_all;
}

void add_options(CLI::App& app, Options& options) {
  app.add_option("--part", options.part, "Of what is measured")
      ->check(CLI::IsMember({"runs", "ideal", "stop-time", "all"}))
      ->capture_default_str();
  app.add_option("--seeds", options.seeds, "How many")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--first-seed", options.first_seed)->capture_default_str();
  app.add_option("--jobs", options.jobs, "Runs at a time")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--rooms", options.rooms, "Bundled names or TOML files")
      ->delimiter(',')
      ->capture_default_str();
  app.add_option("--emulator",
                 options.emulators.emulator,
                 "mixed: the release image under simavr in --simavr-rooms, the mock elsewhere and "
                 "for rough odometry")
      ->check(CLI::IsMember({"mixed", "simavr", "mock"}))
      ->capture_default_str();
  app.add_option("--simavr-rooms", options.emulators.simavr_rooms)
      ->delimiter(',')
      ->capture_default_str();
  app.add_option("--robot", options.robot.profile, "Profile")->capture_default_str();
  app.add_option("--rough-body",
                 options.rough_body,
                 "What is true of the robot with rough odometry; '' makes no runs with it")
      ->capture_default_str();
  app.add_option("--strategy", options.robot.strategy, "stops: a list that covers the room")
      ->check(CLI::IsMember(strategies::strategy_names()))
      ->capture_default_str();
  app.add_option("--timed-stops", options.timed_stops, "Stops before the one that is timed")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1023}))
      ->capture_default_str();
  app.add_option("--keep", options.keep, "Keep the runs and the stop lists in this folder");
  app.add_option("--json", options.json, "Write the figures to this file");
  app.add_option("--markdown", options.markdown, "Write the table for docs to this file");
  app.add_flag("--check", options.check, "Exit with 1 unless every figure is there");
}

int run(Options options) {
  options.robot.radius_m = session::load_robot_profile(options.robot.profile).body_radius_m;
  const session::TemporaryFolder temporary;
  const fs::path folder = options.keep.empty() ? temporary.path() : fs::absolute(options.keep);
  fs::create_directories(folder);
  std::vector<Figure> figures;
  if (options.has("runs") || options.has("ideal")) {
    const std::vector<TruthCell> cells = measure(options, folder);
    figures = truth_figures(cells);
    for (const TruthCell& cell : cells) {
      const auto more = room_figures(cell);
      figures.insert(figures.end(), more.begin(), more.end());
    }
    const std::string table = to_markdown(truth_table(cells));
    fmt::print("{}\n", table);
    if (!options.markdown.empty()) {
      files::write_text_file(options.markdown, table);
    }
  }
  if (options.has("stop-time")) {
    figures.push_back({fmt::format("stop_ms_at_{}", options.timed_stops),
                       stop_ms(options.timed_stops),
                       "ms",
                       1,
                       {}});
  }
  report(figures, options.json);
  return options.check && !has_all_figures(options, figures) ? 1 : 0;
}

}  // namespace
}  // namespace echomap::bench

int main(int argc, char** argv) {
  using namespace echomap::bench;
  Options options;
  CLI::App app(
      "Whether maps tell the truth, in rooms toured by a list of stops, over many seeds: solid "
      "that "
      "is called floor, objects found, paths that collide, and the best map of the same stops");
  add_options(app, options);
  CLI11_PARSE(app, argc, argv);
  try {
    return run(options);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
