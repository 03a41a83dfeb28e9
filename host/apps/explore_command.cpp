// SPDX-License-Identifier: MIT
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

#include "host/apps/commands.hpp"
#include "host/apps/explore_run.hpp"
#include "host/apps/open_robot.hpp"
#include "host/apps/report.hpp"
#include "host/apps/strategy_setup.hpp"
#include "host/pipeline/joined_sessions.hpp"
#include "host/pipeline/observation_fork.hpp"

namespace echomap::apps {

ExitCode run_explore(const ExploreOptions& options) {
  const RobotProfile profile = profile_for(options.run);
  const auto out = run_folder(options.run.out);
  exports::RunSummary summary;
  pipeline::RobotAtlas atlas =
      atlas_for(profile, options.fixes.empty() ? options.run.slam : "none");
  pipeline::ObservationFork fork;
  const auto camera = camera_at(options.fixes, profile, atlas);
  if (camera) {
    fork.add(camera->sink());
  }
  fork.add(atlas);
  pipeline::JoinedSessions sessions(fork);
  const auto resumed = resume_run(options.resume, profile, sessions, atlas);
  prepare_outputs(out, options.run.json);
  OpenedRobot robot = open_robot(options.connection, options.run.seed);
  robot.connection.may_be_lifted = options.fixes.empty() && begins_anywhere(options.run);
  if (robot.lockstep) {
    summary.firmware = robot.lockstep->device().firmware;
    summary.emulator = robot.lockstep->device().emulator;
  }

  RobotSession session(std::move(robot.connection), profile, sessions);
  const ExitCode code =
      explore_and_save({session, atlas, profile, camera.get(), resumed}, options.run, out, summary);
  if (robot.lockstep) {
    robot.lockstep->quit();
  }
  say("map: " + (out / "map.png").string());
  write_report(options.run.json, nlohmann::ordered_json::parse(exports::to_json_text(summary)));
  return code;
}

}  // namespace echomap::apps
