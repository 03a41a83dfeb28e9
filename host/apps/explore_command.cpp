// SPDX-License-Identifier: MIT
#include <cmath>
#include <memory>
#include <random>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

#include "host/apps/commands.hpp"
#include "host/apps/explore_run.hpp"
#include "host/apps/port_choice.hpp"
#include "host/apps/report.hpp"
#include "host/transport/open_stream.hpp"
#include "host/transport/port_identity.hpp"
#include "host/transport/reconnecting_stream.hpp"

namespace echomap::apps {
namespace {

OpenPort opener(const ExploreOptions& options) {
  return
      [baud = options.baud](const std::string& port) { return transport::open_stream(port, baud); };
}

/// A robot that may be unplugged and reset, and is waited for.
RobotConnection connection_on_a_desk(const ExploreOptions& options) {
  RobotConnection robot;
  robot.no_reset = options.no_reset;
  robot.pace = real_time_pace();
  robot.session_id = session_id_from(std::random_device{}());
  const OpenPort open = opener(options);
  robot.stream = choose_port(candidate_ports(options.ports), open, robot.session_id);
  robot.link = transport::is_radio(robot.stream->name()) ? robot_link::radio_link()
                                                         : robot_link::wired_link(options.baud);
  if (options.reconnect_s > 0.0) {
    const transport::PortIdentity identity(robot.stream->name());
    robot.stream = std::make_unique<transport::ReconnectingStream>(
        std::move(robot.stream), [open, identity] { return open(identity.name_now()); });
    robot.patience = std::chrono::milliseconds(std::llround(1e3 * options.reconnect_s));
  }
  return robot;
}

}  // namespace

ExitCode run_explore(const ExploreOptions& options) {
  const RobotProfile profile = profile_for(options.run);
  const auto out = run_folder(options.run.out);
  exports::RunSummary summary;
  prepare_outputs(out, options.run.json);
  RobotConnection robot;
  std::unique_ptr<transport::LockstepChannel> lockstep;
  if (options.lockstep.empty()) {
    robot = connection_on_a_desk(options);
  } else {
    robot.session_id = session_id_from(options.run.seed);
    robot.stream = choose_port(candidate_ports(options.ports), opener(options), robot.session_id);
    lockstep = std::make_unique<transport::LockstepChannel>(options.lockstep);
    robot.pace = lockstep_pace(*lockstep);
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
