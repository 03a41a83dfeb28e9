// SPDX-License-Identifier: MIT
#include <memory>
#include <random>
#include <utility>

#include <nlohmann/json.hpp>

#include "host/apps/commands.hpp"
#include "host/apps/explore_run.hpp"
#include "host/apps/report.hpp"
#include "host/transport/open_stream.hpp"

namespace echomap::apps {

ExitCode run_explore(const ExploreOptions& options) {
  const RobotProfile profile = load_robot_profile(options.run.robot);
  const auto out = run_folder(options.run.out);
  exports::RunSummary summary;
  RobotConnection robot;
  robot.stream = transport::open_stream(options.port, options.baud);
  prepare_outputs(out, options.run.json);

  std::unique_ptr<transport::LockstepChannel> lockstep;
  if (options.lockstep.empty()) {
    robot.pace = real_time_pace();
    robot.session_id = session_id_from(std::random_device{}());
  } else {
    lockstep = std::make_unique<transport::LockstepChannel>(options.lockstep);
    robot.pace = lockstep_pace(*lockstep);
    robot.session_id = session_id_from(options.run.seed);
    summary.firmware = lockstep->device().firmware;
    summary.emulator = lockstep->device().emulator;
  }

  const ExitCode code = explore_and_save(std::move(robot), profile, options.run, out, summary);
  if (lockstep) {
    lockstep->quit();
  }
  say("map: " + (out / "map.png").string());
  write_report(options.run.json, nlohmann::ordered_json::parse(exports::to_json_text(summary)));
  return code;
}

}  // namespace echomap::apps
