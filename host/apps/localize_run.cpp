// SPDX-License-Identifier: MIT
#include "host/apps/localize_run.hpp"

#include <chrono>
#include <memory>
#include <random>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <spdlog/spdlog.h>

#include "host/apps/explore_run.hpp"
#include "host/apps/link_report.hpp"
#include "host/apps/map_file.hpp"
#include "host/apps/report.hpp"
#include "host/console/print.hpp"
#include "host/exports/trajectory_tum.hpp"
#include "host/pipeline/preset_names.hpp"
#include "host/session/firmware_name.hpp"
#include "host/session/open_robot.hpp"
#include "host/tracking/ekf_filter.hpp"
#include "host/tracking/mcl_filter.hpp"

namespace echomap::apps {
namespace {

using nlohmann::ordered_json;

std::unique_ptr<tracking::LiveFilter> filter_for(const LocalizeOptions& options,
                                                 const session::RobotProfile& profile) {
  if (options.filter == "ekf") {
    return std::make_unique<tracking::EkfFilter>(
        profile.geometry,
        tracking::FixStream(tracking::open_fixes(options.fixes)),
        tracking::pose_option(options.camera_at).value_or(geometry::Pose2()),
        tracking::start_pose(options.at));
  }
  return std::make_unique<tracking::MclFilter>(read_map(options.map),
                                               profile.geometry,
                                               tracking::localizer_params(profile, options.preset),
                                               tracking::start_pose(options.at),
                                               std::mt19937(options.run.seed));
}

/// What became of a drive, and where the robot was at its stops.
class Account {
 public:
  Account(const LocalizeOptions& options, const session::RobotProfile& profile) {
    json_["robot"] = profile.name;
    json_["filter"] = options.filter;
    if (options.filter == "mcl") {
      json_["map"] = options.map.string();
      json_["preset"] = pipeline::name_of(options.preset);
    }
    json_["seed"] = options.run.seed;
    json_["stops"] = ordered_json::array();
  }

  void describe(const transport::DeviceInfo& simulated) {
    json_["firmware"] = simulated.firmware;
    json_["emulator"] = simulated.emulator;
  }
  void add_stop(const FollowedRobot& robot) {
    json_["stops"].push_back(robot.filter.report());
    json_["stops"].back()["sim_seconds"] = seconds(robot.session);
  }
  void save(const std::string& outcome,
            const FollowedRobot& robot,
            const std::filesystem::path& out) {
    json_["outcome"] = outcome;
    json_["sim_seconds"] = seconds(robot.session);
    if (const auto& described = robot.session.link().robot();
        described && !json_.contains("firmware")) {
      json_["firmware"] = session::firmware_of(*described);
    }
    json_.update(robot.filter.report());
    exports::write_trajectory_tum(out / "trajectory.tum", robot.filter.trajectory());
    write_report(out / "summary.json", json_);
  }
  std::size_t stops() const { return json_["stops"].size(); }
  const ordered_json& json() const { return json_; }

 private:
  static double seconds(const session::RobotSession& session) {
    return std::chrono::duration<double>(session.now().time_since_epoch()).count();
  }

  ordered_json json_;
};

ExitCode exit_code_of(const FollowedRobot& robot) {
  if (const auto end = robot.session.end()) {
    spdlog::error("{}", robot.session.end_reason());
    return exit_code_of(*end);
  }
  if (robot.driver.finished() == exploration::FinishReason::kCannotSense) {
    spdlog::error(
        "no sweep of the sonar was carried out\n  next: check the pan drive and the "
        "sonar's wires");
    return ExitCode::kRuntimeError;
  }
  return ExitCode::kOk;
}

std::string outcome_of(const FollowedRobot& robot) {
  if (const auto end = robot.session.end()) {
    return outcome_of(*end);
  }
  return exploration::name_of(
      robot.driver.finished().value_or(exploration::FinishReason::kStopLimit));
}

void drive(const FollowedRobot& robot, std::size_t most_stops, Account& account) {
  while (account.stops() < most_stops && follow_to_next_stop(robot)) {
    account.add_stop(robot);
  }
}

}  // namespace

bool follow_to_next_stop(const FollowedRobot& robot) {
  if (!robot.driver.go_to_next_stop()) {
    return false;
  }
  console::print("  " + robot.filter.line());
  if (robot.filter.has_lost_it()) {
    robot.driver.start_anew();
  }
  return true;
}

ExitCode localize_robot(const LocalizeOptions& options, const std::filesystem::path& out) {
  const session::RobotProfile profile = profile_for(options.run);
  const std::unique_ptr<tracking::LiveFilter> filter = filter_for(options, profile);
  session::OpenedRobot opened = session::open_robot(options.connection, options.run.seed);
  opened.connection.may_be_lifted = true;
  pipeline::ObservationFork fork;
  fork.add(filter->sink());
  session::RobotSession session(std::move(opened.connection), profile, fork);
  tracking::StopDriver driver(session, fork, profile, options.run.slam, options.run.seed);
  const FollowedRobot robot{session, driver, *filter};
  session.on_step = [&] { filter->poll(session); };

  Account account(options, profile);
  if (opened.lockstep) {
    account.describe(opened.lockstep->device());
  }
  session.connect();
  filter->begin(session);
  drive(robot, options.run.strategy.stops, account);
  session.disarm();
  account.save(outcome_of(robot), robot, out);
  write_report(options.run.json, account.json());
  if (opened.lockstep) {
    opened.lockstep->quit();
  }
  console::print(fmt::format("{} stops: {}", account.stops(), filter->line()));
  console::print("trajectory: " + (out / "trajectory.tum").string());
  return exit_code_of(robot);
}

}  // namespace echomap::apps
