// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "host/apps/commands.hpp"
#include "host/apps/explore_run.hpp"
#include "host/apps/report.hpp"
#include "host/console/print.hpp"

namespace echomap::apps {

ExitCode run_explore(const ExploreOptions& options) {
  const RunOptions& run = options.run;
  session::RobotContext robot(profile_for(run.robot, run.strategy), session::Seed(run.seed));
  ExploreRun explore{run.strategy, run_folder(run.out), !run.headless, run.align};
  exports::RunSummary summary;
  begin_maps(robot, options.fixes, run.slam);
  explore.resumed = resume_run(options.resume, robot.profile(), robot.sessions(), robot.atlas());
  prepare_outputs(explore.out, run.json);
  open_port(robot, options.connection, run.strategy, summary);

  const ExitCode code = explore_and_save(robot, explore, summary);
  robot.quit();
  console::print("map: " + (explore.out / "map.png").string());
  write_report(run.json, nlohmann::ordered_json::parse(exports::to_json_text(summary)));
  return code;
}

}  // namespace echomap::apps
