// SPDX-License-Identifier: MIT
#include <cstdio>
#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/apps/commands.hpp"
#include "host/apps/explore_run.hpp"
#include "host/apps/report.hpp"
#include "host/apps/simulated_robot.hpp"
#include "host/evaluation/run_score.hpp"
#include "host/files/bundled_files.hpp"
#include "host/transport/open_stream.hpp"

namespace echomap::apps {
namespace {

/// The TOML file of what is true of the robot: the one named, or else the bundled one of the robot
/// that the profile describes.
std::filesystem::path body_of(const DemoOptions& options, const RobotProfile& profile) {
  return files::bundled_file(
      options.body.empty() ? profile.name : options.body, "hil_mock/robots", "body (--body)");
}

}  // namespace

ExitCode run_demo(const DemoOptions& options) {
  const RobotProfile profile = load_robot_profile(options.run.robot);
  const auto body = body_of(options, profile);
  const auto out = run_folder(options.run.out);
  SimulatedRobot robot(options, body, out);
  const transport::DeviceInfo& device = robot.lockstep().device();
  exports::RunSummary summary;
  summary.world = options.world;
  summary.firmware = device.firmware;
  summary.emulator = device.emulator;

  const ExitCode code = explore_and_save({transport::open_stream(robot.port(), 0),
                                          lockstep_pace(robot.lockstep()),
                                          session_id_from(options.run.seed)},
                                         profile,
                                         options.run,
                                         out,
                                         summary);
  fmt::print(stderr, "map: {}\n", (out / "map.png").string());
  if (!robot.lockstep().quit()) {
    return code;
  }
  const auto score = evaluation::score_run(out, robot.truth());
  fmt::print(stderr,
             "{} under {} explored {}: {} stops, {:.0f} s of robot time in {:.1f} s\n",
             device.firmware,
             device.emulator,
             options.world,
             summary.stops,
             summary.sim_seconds,
             summary.wall_seconds);
  print_score(score);
  auto report = nlohmann::ordered_json::parse(exports::to_json_text(summary));
  report.update(to_json(score));
  write_report(options.run.json, report);
  return code;
}

}  // namespace echomap::apps
