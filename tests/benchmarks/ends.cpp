// SPDX-License-Identifier: MIT
// How runs end: whether any room is finished, whether a map that says so is, and how long it takes,
// over many seeds, beside another strategy; whether robots with a hidden fault are told it; whether
// robots that are carried off in the maps that they have made find themselves in them; and whether
// users are told how a run ended and what to do next.
#include <exception>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "host/files/atomic_file.hpp"
#include "host/session/robot_profile.hpp"
#include "host/session/temporary_folder.hpp"
#include "host/strategies/strategy_setup.hpp"
#include "tests/benchmarks/carried_runs.hpp"
#include "tests/benchmarks/ends_figures.hpp"
#include "tests/benchmarks/fault_runs.hpp"
#include "tests/benchmarks/figures.hpp"
#include "tests/benchmarks/markdown_table.hpp"
#include "tests/benchmarks/told_ends.hpp"
#include "tests/benchmarks/truth_rooms.hpp"
#include "tests/benchmarks/truth_runs.hpp"

namespace echomap::bench {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::string part = "all";
  std::size_t robots = 200;
  int seeds = 20;
  int first_seed = 1;
  int jobs = 2;
  std::vector<std::string> rooms = truth_room_names();
  TruthEmulators emulators;
  TruthRobot robot;
  std::string peer = "nxt-farthest";
  fs::path keep;
  fs::path json;
  fs::path markdown;

  bool has(const char* name) const { return part == "all" || part == name; }
};

/// A run that is still to be made.
struct Task {
  std::size_t room = 0;
  int seed = 0;
  bool is_peer = false;
};

std::vector<Task> tasks_of(const Options& options) {
  std::vector<Task> tasks;
  for (std::size_t room = 0; room < options.rooms.size(); ++room) {
    for (int seed = options.first_seed; seed < options.first_seed + options.seeds; ++seed) {
      tasks.push_back({room, seed, false});
      if (!options.peer.empty()) {
        tasks.push_back({room, seed, true});
      }
    }
  }
  return tasks;
}

void print_run(const TruthRoom& room,
               const std::string& strategy,
               const Task& task,
               const TruthRun& run) {
  fmt::print(
      stderr,
      "{:14} seed {:3} {:12} {}, {}: {} stops, {:.0f} s, coverage {:.2f}, floor_seen {:.2f}, "
      "free_iou {:.3f}\n",
      room.name,
      task.seed,
      strategy,
      run.finished ? "finished" : "unfinished",
      run.outcome,
      run.stops,
      run.sim_seconds,
      run.coverage,
      run.score.fitted.floor_seen,
      run.score.start.map.free_iou);
}

std::optional<TruthRun> carry_out(const Options& options,
                                  const TruthRoom& room,
                                  const Task& task,
                                  const fs::path& folder) {
  TruthRobot robot = options.robot;
  if (task.is_peer) {
    robot.strategy = options.peer;
  }
  const fs::path place = folder / fmt::format("{}_{}_{}", room.name, robot.strategy, task.seed);
  const auto run = run_truth(room, robot, task.seed, place);
  if (options.keep.empty()) {
    fs::remove_all(place);
  }
  if (run) {
    print_run(room, robot.strategy, task, *run);
  }
  return run;
}

std::vector<EndsCell> measure(const Options& options, const fs::path& folder) {
  std::vector<TruthRoom> rooms;
  std::vector<EndsCell> cells;
  for (const std::string& world : options.rooms) {
    rooms.push_back(truth_room(world, options.emulators));
    cells.push_back({rooms.back().name, static_cast<std::size_t>(options.seeds), {}, {}});
  }
  const std::vector<Task> tasks = tasks_of(options);
  std::vector<std::optional<TruthRun>> runs(tasks.size());
  for_each_in_jobs(tasks.size(), options.jobs, [&](std::size_t i) {
    runs[i] = carry_out(options, rooms[tasks[i].room], tasks[i], folder);
  });
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    if (runs[i]) {
      EndsCell& cell = cells[tasks[i].room];
      (tasks[i].is_peer ? cell.peer_runs : cell.runs).push_back(*std::move(runs[i]));
    }
  }
  return cells;
}

std::vector<FaultFinding> find_faults(const Options& options, const fs::path& folder) {
  const auto robots = draw_robots(options.rooms, options.robots, options.first_seed);
  std::vector<FaultFinding> findings(robots.size());
  for_each_in_jobs(robots.size(), options.jobs, [&](std::size_t i) {
    const fs::path place = folder / fmt::format("robot_{}", i);
    findings[i] = find_fault(robots[i], place);
    if (options.keep.empty()) {
      fs::remove_all(place);
    }
  });
  return findings;
}

std::vector<CarriedRun> carry_off_all(const Options& options, const fs::path& folder) {
  std::vector<TruthRoom> rooms;
  for (const std::string& world : options.rooms) {
    rooms.push_back(truth_room(world, options.emulators));
  }
  const auto seeds = static_cast<std::size_t>(options.seeds);
  std::vector<CarriedRun> runs(rooms.size() * seeds);
  for_each_in_jobs(runs.size(), options.jobs, [&](std::size_t i) {
    const TruthRoom& room = rooms[i / seeds];
    const int seed = options.first_seed + static_cast<int>(i % seeds);
    const fs::path place = folder / fmt::format("{}_carried_{}", room.name, seed);
    runs[i] = carry_off(room, options.robot, seed, place);
    if (options.keep.empty()) {
      fs::remove_all(place);
    }
  });
  return runs;
}

std::vector<ToldEnd> tell_ends(const Options& options, const fs::path& folder) {
  const std::vector<test::StagedEnd>& staged = test::staged_ends();
  std::vector<ToldEnd> ends(staged.size());
  for_each_in_jobs(staged.size(), options.jobs, [&](std::size_t i) {
    const fs::path place = folder / staged[i].name;
    ends[i] = tell_end(staged[i], place);
    if (options.keep.empty()) {
      fs::remove_all(place);
    }
  });
  return ends;
}

void add_options(CLI::App& app, Options& options) {
  app.add_option(
         "--part",
         options.part,
         "runs: how explorations end; faults: what robots are told; carried: whether they find "
         "themselves in their own maps; told: whether twelve staged ends are reported with the "
         "right exit code, outcome and next step")
      ->check(CLI::IsMember({"runs", "faults", "carried", "told", "all"}))
      ->capture_default_str();
  app.add_option("--robots", options.robots, "Robots with a fault, and as many without")
      ->check(CLI::PositiveNumber)
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
                 "mixed: the release image under simavr in --simavr-rooms, the mock elsewhere")
      ->check(CLI::IsMember({"mixed", "simavr", "mock"}))
      ->capture_default_str();
  app.add_option("--simavr-rooms", options.emulators.simavr_rooms)
      ->delimiter(',')
      ->capture_default_str();
  app.add_option("--robot", options.robot.profile, "Profile")->capture_default_str();
  app.add_option("--strategy", options.robot.strategy)
      ->check(CLI::IsMember(strategies::strategy_names()))
      ->capture_default_str();
  app.add_option("--peer", options.peer, "Strategy to compare the time with; '' for none")
      ->capture_default_str();
  app.add_option("--keep", options.keep, "Keep the runs in this folder");
  app.add_option("--json", options.json, "Write the figures to this file");
  app.add_option("--markdown", options.markdown, "Write the table for docs to this file");
}

int run(Options options) {
  options.robot.radius_m = session::load_robot_profile(options.robot.profile).body_radius_m;
  const session::TemporaryFolder temporary;
  const fs::path folder = options.keep.empty() ? temporary.path() : fs::absolute(options.keep);
  fs::create_directories(folder);
  std::string table;
  std::vector<Figure> figures;
  const auto add = [&](const MarkdownTable& part, const std::vector<Figure>& of_part) {
    table += (table.empty() ? "" : "\n") + to_markdown(part);
    figures.insert(figures.end(), of_part.begin(), of_part.end());
  };
  if (options.has("runs")) {
    const std::vector<EndsCell> cells = measure(options, folder);
    add(ends_table(cells), ends_figures(cells));
  }
  if (options.has("faults")) {
    const std::vector<FaultFinding> findings = find_faults(options, folder);
    add(fault_table(findings), fault_figures(findings));
  }
  if (options.has("carried")) {
    const std::vector<CarriedRun> runs = carry_off_all(options, folder);
    add(carried_table(runs), carried_figures(runs));
  }
  if (options.has("told")) {
    const std::vector<ToldEnd> ends = tell_ends(options, folder);
    add(told_table(ends), told_figures(ends));
  }
  fmt::print("{}\n", table);
  if (!options.markdown.empty()) {
    files::write_text_file(options.markdown, table);
  }
  report(figures, options.json);
  return 0;
}

}  // namespace
}  // namespace echomap::bench

int main(int argc, char** argv) {
  using namespace echomap::bench;
  Options options;
  options.robot.strategy = "frontier";
  CLI::App app("Whether explorations finish any room, whether a map that is called finished is");
  add_options(app, options);
  CLI11_PARSE(app, argc, argv);
  try {
    return run(options);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
