// SPDX-License-Identifier: MIT
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

#include "host/apps/commands.hpp"
#include "host/apps/explore_run.hpp"
#include "host/apps/report.hpp"
#include "host/console/print.hpp"
#include "host/pipeline/joined_sessions.hpp"
#include "host/pipeline/observation_fork.hpp"
#include "host/session/open_robot.hpp"
#include "host/session/pipeline_setup.hpp"
#include "host/strategies/strategy_setup.hpp"

namespace echomap::apps {

ExitCode run_explore(const ExploreOptions& options) {
  const session::RobotProfile profile = profile_for(options.run);
  const auto out = run_folder(options.run.out);
  exports::RunSummary summary;
  pipeline::RobotAtlas atlas =
      session::atlas_for(profile, options.fixes.empty() ? options.run.slam : session::kNoSlam);
  pipeline::ObservationFork fork;
  const auto camera = tracking::camera_at(options.fixes, profile, atlas);
  if (camera) {
    fork.add(camera->sink());
  }
  fork.add(atlas);
  pipeline::JoinedSessions sessions(fork);
  const auto resumed = resume_run(options.resume, profile, sessions, atlas);
  prepare_outputs(out, options.run.json);
  session::OpenedRobot robot = session::open_robot(options.connection, options.run.seed);
  robot.connection.may_be_lifted =
      options.fixes.empty() && strategies::begins_anywhere(options.run.strategy);
  if (robot.lockstep) {
    summary.firmware = robot.lockstep->device().firmware;
    summary.emulator = robot.lockstep->device().emulator;
  }

  session::RobotSession session(std::move(robot.connection), profile, sessions);
  const ExitCode code =
      explore_and_save({session, atlas, profile, camera.get(), resumed}, options.run, out, summary);
  if (robot.lockstep) {
    robot.lockstep->quit();
  }
  console::print("map: " + (out / "map.png").string());
  write_report(options.run.json, nlohmann::ordered_json::parse(exports::to_json_text(summary)));
  return code;
}

}  // namespace echomap::apps
