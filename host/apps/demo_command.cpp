// SPDX-License-Identifier: MIT
#include <exception>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/apps/commands.hpp"
#include "host/apps/demo_kidnap.hpp"
#include "host/apps/explore_run.hpp"
#include "host/apps/kidnap_report.hpp"
#include "host/apps/live_run.hpp"
#include "host/apps/report.hpp"
#include "host/apps/room_fit.hpp"
#include "host/apps/run_recording.hpp"
#include "host/apps/run_words.hpp"
#include "host/boards/boards.hpp"
#include "host/console/print.hpp"
#include "host/console/shell_line.hpp"
#include "host/evaluation/run_score.hpp"
#include "host/evaluation/truth_directory.hpp"
#include "host/files/bundled_files.hpp"
#include "host/files/toml_reader.hpp"
#include "host/session/profile_driver.hpp"
#include "host/session/simulated_robots.hpp"

namespace echomap::apps {
namespace {

using session::RobotContext;
using session::RobotProfile;

/// Times real time: fast enough not to bore, slow enough to follow.
constexpr double kWatchedSpeed = 8.0;

/// A room that every robot without a sonar can walk around.
constexpr const char* kContactRoom = "create_l";

/// The TOML file of what is true of the robot: the one named, or else the bundled one of the robot
/// that the profile describes.
std::filesystem::path body_of(const std::string& named, const RobotProfile& profile) {
  return files::bundled_file(
      named.empty() ? profile.name : named, "hil_mock/robots", "body (--body)");
}

/// The profile that is asked for, with another motor driver where one is named.
RobotProfile profile_of(const DemoOptions& options) {
  RobotProfile profile = profile_for(options.run.robot, options.run.strategy);
  const std::string& driver = options.robot.driver;
  return driver.empty() ? profile
                        : session::parse_robot_profile(session::with_driver(profile.toml, driver),
                                                       options.run.robot + " with --driver");
}

/// Ends the command where the board cannot carry the profile's motor driver, before anything
/// starts.
void refuse_unfit_driver(const std::string& name, const RobotProfile& profile) {
  if (name.empty()) {
    return;
  }
  const boards::Board& board = boards::board_named(name);
  const auto kind = static_cast<protocol::MotorBridgeKind>(profile.configuration.wiring.bridge);
  if (!boards::carries(board, kind)) {
    throw CommandError(
        ExitCode::kConfigInvalid,
        fmt::format("the {} cannot carry the motor driver of profile '{}', {}: it carries {}\n"
                    "  next: another driver, or another --board: {}",
                    board.what,
                    profile.name,
                    boards::words_of(kind),
                    boards::bridges_of(board),
                    fmt::join(boards::emulated_boards_that_carry(kind), ", ")));
  }
}

/// The demo that is asked for, in another room and on another board where these are named, as a
/// command: what decides which robot drives where and how, and what differs from the board's own.
console::CommandWords demo_words(const DemoOptions& options,
                                 const std::string& world,
                                 const std::string& board) {
  const session::SimulatedRobotOptions& robot = options.robot;
  console::CommandWords words{"echomap", "demo", "--world", world};
  const auto say = [&words](const char* option, const std::string& value) {
    words.insert(words.end(), {option, value});
  };
  say(board.empty() ? "--emulator" : "--board", board.empty() ? robot.emulator : board);
  const std::string usual =
      board.empty() ? RunOptions().robot : std::string(boards::board_named(board).robot);
  if (options.run.robot != usual) {
    say("--robot", options.run.robot);
  }
  if (!robot.body.empty()) {
    say("--body", robot.body);
  }
  if (!robot.driver.empty()) {
    say("--driver", robot.driver);
  }
  if (!robot.fixes.empty()) {
    say("--fixes", robot.fixes);
  }
  if (!robot.camera_params.empty()) {
    say("--camera-params", robot.camera_params);
  }
  const console::CommandWords strategy = strategy_words(options.run);
  words.insert(words.end(), strategy.begin(), strategy.end());
  return words;
}

std::string demo_line(const DemoOptions& options) {
  return console::shell_line(demo_words(options, options.robot.world, options.robot.board));
}

/// The same demo by a strategy that looks for floor until there is none, where the robot can.
std::string demo_by_frontier(DemoOptions options) {
  const strategies::StrategyOptions usual;
  options.run.strategy = usual;
  console::CommandWords words = demo_words(options, options.robot.world, options.robot.board);
  words.insert(words.end(), {"--strategy", usual.name});
  return console::shell_line(words);
}

/// Ends the command where the body is wired for other boards, before anything starts. One without
/// [wiring] is for every board.
void refuse_unwired_body(const DemoOptions& options,
                         const RobotProfile& profile,
                         const std::filesystem::path& body) {
  const std::string& board = options.robot.board;
  const auto file = files::TomlReader::load(body);
  if (board.empty() || !file.has("wiring") || file.table("wiring").has(board)) {
    return;
  }
  const auto kind = static_cast<protocol::MotorBridgeKind>(profile.configuration.wiring.bridge);
  std::vector<std::string> others = boards::emulated_boards_that_carry(kind);
  std::erase_if(others, [&](const std::string& other) { return !file.table("wiring").has(other); });
  const std::string what =
      fmt::format("the robot '{}' is not wired for --board {}", profile.name, board);
  throw CommandError(
      ExitCode::kConfigInvalid,
      others.empty()
          ? fmt::format("{}\n  next: wire it in {}: [wiring.{}]", what, body.string(), board)
          : fmt::format(
                "{}, but for {}\n  next: {}",
                what,
                fmt::join(others, ", "),
                console::shell_line(demo_words(options, options.robot.world, others.front()))));
}

/// The simulated robot has the driver that its profile names.
session::SimulatedRobotOptions with_driver_of(const RobotProfile& profile,
                                              session::SimulatedRobotOptions robot) {
  robot.driver = session::driver_of(profile.toml);
  return robot;
}

void print_what_ran(const exports::RunSummary& summary) {
  console::print(
      fmt::format("{} under {} explored {}: {} stops, {:.0f} s of robot time in {:.1f} s",
                  summary.firmware,
                  summary.emulator,
                  summary.world,
                  summary.stops,
                  summary.sim_seconds,
                  summary.wall_seconds));
}

/// Ends the robot and adds the scores to `report`; answers why there are none, empty where there
/// are.
std::string add_scores(RobotContext& robot,
                       const std::filesystem::path& out,
                       const std::filesystem::path& truth,
                       nlohmann::ordered_json& report) {
  try {
    if (!robot.quit()) {
      return "the simulated robot ended without writing its truth; see " +
             (out / "robot.log").string();
    }
    const auto score = evaluation::score_run(out, truth, radius_of_robot(out));
    print_score(score);
    report.update(to_json(score));
    return "";
  } catch (const std::exception& error) {
    return error.what();
  }
}

/// What there is to do with the map of a simulated robot: the next one begins in the same room. A
/// run without a limit of stops would end again as it has, unless another strategy makes it.
NextCommands next_commands(const DemoOptions& options,
                           const RobotProfile& profile,
                           const std::filesystem::path& out) {
  const std::string score = console::shell_line({"echomap",
                                                 "eval",
                                                 out.string(),
                                                 "--truth",
                                                 (out / "truth").string(),
                                                 "--picture",
                                                 (out / "score.png").string()});
  console::CommandWords find{"echomap", "localize", "--map", out.string()};
  const console::CommandWords robot = robot_words(options.run);
  find.insert(find.end(), robot.begin(), robot.end());
  const std::string again = demo_line(options);
  const strategies::StrategyOptions& strategy = options.run.strategy;
  const bool is_frontier = strategy.name == strategies::StrategyOptions().name;
  const std::string more = is_frontier         ? score
                           : profile.has_sonar ? demo_by_frontier(options)
                                               : again;
  return {score, strategy.stops ? again : more, console::shell_line(find), again};
}

/// How a drive has ended, and what became of a robot that was carried off behind it.
struct DemoDrive {
  RunEnding ending;
  std::optional<DemoKidnap> kidnap;
};

DemoDrive drive(RobotContext& robot,
                LiveRun& live,
                const DemoOptions& options,
                const std::filesystem::path& out,
                exports::RunSummary& summary) {
  const NextCommands next = next_commands(options, robot.profile(), out);
  DemoDrive drive{explore_and_save(robot,
                                   {options.run.strategy,
                                    live,
                                    out,
                                    progress_display(options.run),
                                    options.run.align,
                                    split_bytes(options.run),
                                    next},
                                   summary),
                  std::nullopt};
  if (options.no_kidnap || !robot.profile().has_sonar) {
    return drive;
  }
  if (!drive.ending.finished()) {
    console::print("not carried off: only a robot with a finished map looks for its place in it");
    return drive;
  }
  robot.end_maps();
  drive.kidnap = show_kidnap(robot, live, options.run.slam);
  if (const auto end = robot.session().end()) {
    drive.ending =
        ending_of(*end, "relocalization stopped early: " + robot.session().end_reason(), next);
  }
  return drive;
}

/// Ends the robot and writes the report; answers how the demo has ended.
RunEnding report_on(const DemoDrive& drive,
                    RobotContext& robot,
                    const DemoOptions& options,
                    const std::filesystem::path& truth,
                    const std::filesystem::path& out,
                    exports::RunSummary& summary) {
  RunEnding ending = drive.ending;
  auto scores = nlohmann::ordered_json::object();
  const std::string unscored = add_scores(robot, out, truth, scores);
  if (drive.kidnap && unscored.empty()) {
    scores["kidnap"] = kidnap_report(*drive.kidnap, evaluation::read_truth(truth).trajectory);
    console::print(kidnap_line(scores["kidnap"]));
    if (ending.finished() && !scores["kidnap"]["found"].get<bool>()) {
      ending.code = ExitCode::kUnfinished;
      ending.why += "; carried off, it did not find its place in it again";
    }
  }
  if (!summary.coverage && unscored.empty()) {
    const auto larger = console::shell_line(demo_words(options, kContactRoom, options.robot.board));
    ending = with_narrow_room(ending, evaluation::read_truth(truth), robot.profile(), larger);
  }
  if (ending.finished() && !unscored.empty()) {
    ending.code = ExitCode::kRuntimeError;
    ending.why = "the map has no score: " + unscored;
  }
  describe_ending(ending, summary);
  auto report = nlohmann::ordered_json::parse(exports::to_json_text(summary));
  report.update(scores);
  write_report(out / "summary.json", report);
  end_recording(robot, report, out);
  write_report(options.run.json, report);
  return ending;
}

}  // namespace

ExitCode run_demo(const DemoOptions& options) {
  const RunOptions& run = options.run;
  RobotProfile profile = profile_of(options);
  refuse_unfit_driver(options.robot.board, profile);
  const auto body = body_of(options.robot.body, profile);
  refuse_unwired_body(options, profile, body);
  validate_slam(run, profile);
  const auto out = run_folder(run.out);
  prepare_outputs(out, run.json, run.force);
  const session::Seed seed(run.seed);
  session::SimulatedRobots simulated(with_driver_of(profile, options.robot), seed, body, out);
  RobotContext robot(std::move(profile), seed);
  exports::RunSummary summary;
  summary.world = options.robot.world;
  LiveRun live(options.live, robot, {.command = "demo", .out = out, .is_simulated = true});
  begin_maps(robot, options.robot.fixes, run.slam);
  open_port(robot, simulated.connection(), run.strategy, summary);
  if (live.serves()) {
    robot.time_scale().set_factor(
        options.speed.value_or(live.may_be_watched() ? kWatchedSpeed : 0.0));
    robot.lockstep()->tell_truth();
    live.score_against(simulated.truth());
  } else {
    robot.time_scale().set_factor(options.speed.value_or(0.0));
  }

  const DemoDrive driven = drive(robot, live, options, out, summary);
  console::print("map: " + (out / "map.png").string());
  print_what_ran(summary);
  const RunEnding ending = report_on(driven, robot, options, simulated.truth(), out, summary);
  print_ending(ending);
  live.end(ending);
  return ending.code;
}

}  // namespace echomap::apps
