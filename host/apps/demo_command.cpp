// SPDX-License-Identifier: MIT
#include <exception>
#include <filesystem>
#include <optional>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <spdlog/spdlog.h>

#include "host/apps/commands.hpp"
#include "host/apps/demo_kidnap.hpp"
#include "host/apps/explore_run.hpp"
#include "host/apps/report.hpp"
#include "host/console/print.hpp"
#include "host/evaluation/run_score.hpp"
#include "host/evaluation/truth_directory.hpp"
#include "host/files/bundled_files.hpp"
#include "host/session/open_robot.hpp"
#include "host/session/pipeline_setup.hpp"
#include "host/session/simulated_robot.hpp"
#include "host/strategies/strategy_setup.hpp"
#include "host/transport/open_stream.hpp"

namespace echomap::apps {
namespace {

/// The TOML file of what is true of the robot: the one named, or else the bundled one of the robot
/// that the profile describes.
std::filesystem::path body_of(const DemoOptions& options, const session::RobotProfile& profile) {
  return files::bundled_file(options.robot.body.empty() ? profile.name : options.robot.body,
                             "hil_mock/robots",
                             "body (--body)");
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
std::string add_scores(session::SimulatedRobot& robot,
                       const std::filesystem::path& out,
                       nlohmann::ordered_json& report) {
  try {
    if (!robot.lockstep().quit()) {
      return "the simulated robot ended without its truth; see " + (out / "robot.log").string();
    }
    const auto score = evaluation::score_run(out, robot.truth());
    print_score(score);
    report.update(to_json(score));
    return "";
  } catch (const std::exception& error) {
    return error.what();
  }
}

session::RobotConnection connection_to(session::SimulatedRobot& robot, const DemoOptions& options) {
  session::RobotConnection connection;
  connection.stream = transport::open_stream(robot.port(), 0);
  connection.pace = session::lockstep_pace(robot.lockstep());
  connection.session_id = session::session_id_from(options.run.seed);
  connection.may_be_lifted =
      options.robot.fixes.empty() && strategies::begins_anywhere(options.run.strategy);
  if (options.robot.line == "bluetooth") {
    connection.link = robot_link::radio_link();
  }
  return connection;
}

/// How a drive has ended, and what became of a robot that was carried off behind it.
struct DemoDrive {
  ExitCode code = ExitCode::kOk;
  std::optional<DemoKidnap> kidnap;
};

DemoDrive drive(session::SimulatedRobot& robot,
                const DemoOptions& options,
                const session::RobotProfile& profile,
                const std::filesystem::path& out,
                exports::RunSummary& summary) {
  pipeline::RobotAtlas atlas =
      session::atlas_for(profile, options.robot.fixes.empty() ? options.run.slam : session::kNoSlam);
  pipeline::ObservationFork fork;
  const auto camera = tracking::camera_at(options.robot.fixes, profile, atlas);
  if (camera) {
    fork.add(camera->sink());
  }
  fork.add(atlas);
  session::RobotSession session(connection_to(robot, options), profile, fork);
  const DrivenRobot driven{session, atlas, profile, camera.get()};
  DemoDrive drive;
  drive.code = explore_and_save(driven, options.run, out, summary);
  if (drive.code != ExitCode::kOk || options.no_kidnap || !profile.has_sonar) {
    return drive;
  }
  fork.remove(atlas);
  drive.kidnap = show_kidnap(driven, fork, robot.lockstep(), options.run);
  if (const auto end = session.end()) {
    spdlog::error("the map is kept; the robot did not look for itself to the end, for {}",
                  session.end_reason());
    drive.code = exit_code_of(*end);
  }
  return drive;
}

/// Ends the robot and writes the report; answers why there are no scores, empty where there are.
std::string report_on(const DemoDrive& drive,
                      session::SimulatedRobot& robot,
                      const DemoOptions& options,
                      const std::filesystem::path& out,
                      const exports::RunSummary& summary) {
  auto report = nlohmann::ordered_json::parse(exports::to_json_text(summary));
  std::string unscored = add_scores(robot, out, report);
  if (drive.kidnap && unscored.empty()) {
    report["kidnap"] =
        kidnap_report(*drive.kidnap, evaluation::read_truth(robot.truth()).trajectory);
    console::print(kidnap_line(report["kidnap"]));
  }
  write_report(out / "summary.json", report);
  write_report(options.run.json, report);
  return unscored;
}

}  // namespace

ExitCode run_demo(const DemoOptions& options) {
  const session::RobotProfile profile = profile_for(options.run);
  const auto body = body_of(options, profile);
  const auto out = run_folder(options.run.out);
  prepare_outputs(out, options.run.json);
  session::SimulatedRobot robot(options.robot, options.run.seed, body, out);
  const transport::DeviceInfo& device = robot.lockstep().device();
  exports::RunSummary summary;
  summary.world = options.robot.world;
  summary.firmware = device.firmware;
  summary.emulator = device.emulator;

  const DemoDrive driven = drive(robot, options, profile, out, summary);
  console::print("map: " + (out / "map.png").string());
  print_what_ran(summary);
  const std::string unscored = report_on(driven, robot, options, out, summary);
  if (unscored.empty()) {
    return driven.code;
  }
  spdlog::error("the map has no score: {}", unscored);
  return driven.code == ExitCode::kOk ? ExitCode::kRuntimeError : driven.code;
}

}  // namespace echomap::apps
