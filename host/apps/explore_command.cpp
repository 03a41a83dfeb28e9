// SPDX-License-Identifier: MIT
#include <filesystem>
#include <initializer_list>

#include <nlohmann/json.hpp>

#include "host/apps/commands.hpp"
#include "host/apps/explore_run.hpp"
#include "host/apps/live_run.hpp"
#include "host/apps/report.hpp"
#include "host/apps/run_recording.hpp"
#include "host/apps/run_words.hpp"
#include "host/console/print.hpp"
#include "host/console/shell_line.hpp"

namespace echomap::apps {
namespace {

bool is_same_folder(const std::filesystem::path& one, const std::filesystem::path& other) {
  return exists(one) && exists(other) && equivalent(one, other);
}

/// With the words that name the robot and, where it explores, the strategy.
NextCommands next_commands(const ExploreOptions& options, const std::string& out) {
  console::CommandWords robot;
  for (const std::string& port : options.connection.ports) {
    robot.insert(robot.end(), {"--port", port});
  }
  const console::CommandWords name = robot_words(options.run);
  robot.insert(robot.end(), name.begin(), name.end());
  const auto line = [&](const char* command, std::initializer_list<console::CommandWords> more) {
    console::CommandWords words{"echomap", command};
    words.insert(words.end(), robot.begin(), robot.end());
    for (const console::CommandWords& each : more) {
      words.insert(words.end(), each.begin(), each.end());
    }
    return console::shell_line(words);
  };
  const console::CommandWords strategy = strategy_words(options.run);
  const std::string localize = line("localize", {{"--map", out}});
  return {localize,
          line("explore", {strategy, {"--resume", out, "--out", out}}),
          localize,
          line("explore", {strategy})};
}

}  // namespace

ExitCode run_explore(const ExploreOptions& options) {
  const RunOptions& run = options.run;
  session::RobotContext robot(profile_for(run.robot, run.strategy), session::Seed(run.seed));
  validate_slam(run, robot.profile());
  const auto out = run_folder(run.out);
  LiveRun live(options.live, robot, {.command = "explore", .out = out});
  ExploreRun explore{run.strategy, live, out, progress_display(run), run.align, split_bytes(run)};
  explore.next = next_commands(options, out.string());
  exports::RunSummary summary;
  begin_maps(robot, options.fixes, run.slam);
  explore.resumed = resume_run(options.resume, robot);
  prepare_outputs(out, run.json, run.force || is_same_folder(options.resume, out));
  open_port(robot, options.connection, run.strategy, summary);

  const RunEnding ending = explore_and_save(robot, explore, summary);
  robot.quit();
  console::print("map: " + (out / "map.png").string());
  const auto report = nlohmann::ordered_json::parse(exports::to_json_text(summary));
  end_recording(robot, report, out);
  write_report(run.json, report);
  print_ending(ending);
  live.end(ending);
  return ending.code;
}

}  // namespace echomap::apps
