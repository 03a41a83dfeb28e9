// SPDX-License-Identifier: MIT
#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "host/apps/commands.hpp"
#include "host/apps/explore_run.hpp"
#include "host/apps/fleet_map_files.hpp"
#include "host/apps/fleet_page.hpp"
#include "host/apps/fleet_progress.hpp"
#include "host/apps/fleet_score.hpp"
#include "host/apps/fleet_watch.hpp"
#include "host/apps/member_processes.hpp"
#include "host/apps/report.hpp"
#include "host/apps/source_report.hpp"
#include "host/apps/source_setup.hpp"
#include "host/broker/broker.hpp"
#include "host/console/interrupt.hpp"
#include "host/console/print.hpp"
#include "host/console/shell_line.hpp"
#include "host/files/bundled_files.hpp"
#include "host/session/profile_driver.hpp"
#include "host/session/simulated_robots.hpp"

namespace echomap::apps {
namespace {

namespace fs = std::filesystem;
using session::RobotProfile;

constexpr const char* kFleet = "demo";
constexpr const char* kHub = "hub";
/// Who looks on beside.
constexpr const char* kWatch = "watch";

std::string robot_name(std::size_t robot) { return fmt::format("robot{}", robot); }

std::vector<std::string> robot_names(std::size_t robots) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < robots; ++i) {
    names.push_back(robot_name(i));
  }
  return names;
}

/// What a member that dies would leave of a run before this one, and what the broker has kept of
/// its robots: they had the same names, and begin to count anew.
void forget_earlier_run(const fs::path& out, const std::vector<std::string>& robots) {
  fs::remove_all(out / "truth");
  fs::remove_all(out / "broker" / "store");
  for (const std::string& robot : robots) {
    fs::remove(out / robot / "summary.json");
    fs::remove(out / robot / "source.json");
  }
}

broker::BrokerSettings broker_settings(const FleetStartOptions& options) {
  broker::BrokerSettings settings;
  settings.fleet = kFleet;
  settings.tls = options.tls;
  settings.hub = kHub;
  for (const std::string& name : robot_names(options.robot.robots)) {
    settings.users.push_back({name, broker::random_password()});
  }
  settings.users.push_back({kHub, broker::random_password()});
  settings.users.push_back({kWatch, broker::random_password()});
  return settings;
}

/// `echomap fleet join` of a simulated robot.
std::vector<std::string> join_command(const FleetStartOptions& options,
                                      const broker::Broker& broker,
                                      const session::ConnectionOptions& connection,
                                      const std::string& name,
                                      const fs::path& folder) {
  std::vector<std::string> command{session::program_folder() / "echomap",
                                   "fleet",
                                   "join",
                                   "--as",
                                   broker.credentials_file(name),
                                   "--port",
                                   connection.ports.front(),
                                   "--lockstep",
                                   connection.lockstep,
                                   "--robot",
                                   options.run.robot,
                                   "--seed",
                                   std::to_string(options.run.seed),
                                   "--out",
                                   folder,
                                   "--force",
                                   "--headless"};
  for (const std::string& each : robot_names(options.robot.robots)) {
    command.insert(command.end(), {"--round-with", each});
  }
  if (options.search) {
    command.insert(command.end(),
                   {"--search", "--search-seconds", fmt::format("{}", options.max_s)});
  }
  return command;
}

MemberProcesses start_members(const FleetStartOptions& options,
                              const broker::Broker& broker,
                              const session::SimulatedRobots& robots,
                              const fs::path& out) {
  MemberProcesses members;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    const std::string name = robot_name(i);
    const fs::path folder = out / name;
    fs::create_directories(folder);
    members.start(name,
                  join_command(options, broker, robots.connection(i), name, folder),
                  folder / "join.log");
  }
  return members;
}

/// Shows the fleet, and says how far it is, while its members go on.
void look_on(MemberProcesses& members,
             broker::Broker& broker,
             FleetWatch& watch,
             fleet_member::TeamPicture& picture,
             FleetPage& page) {
  FleetProgressPrinter progress;
  double next_look_s = 0.0;
  bool is_interrupted = false;
  while (members.go_on()) {
    page.hear(watch.listen());
    if (console::interrupted() && !is_interrupted) {
      is_interrupted = true;
      members.interrupt();
    }
    if (!broker.is_running()) {
      members.interrupt();
      members.wait_for_all();
      throw CommandError(
          ExitCode::kRuntimeError,
          "the broker has ended\n  next: see " + (broker.folder() / "mosquitto.log").string());
    }
    if (watch.now_s() >= next_look_s) {
      const fleet::FleetState state = watch.state();
      if (!is_interrupted && members.has_lost_one_unheard(state)) {
        is_interrupted = true;
        members.interrupt();
      }
      const std::string first_map = latest_map(state, members.names().front());
      picture.take_with_joins(state);
      page.show(watch.now_s(), state, picture, first_map);
      progress.print(progress_of(state, picture, first_map));
      next_look_s = watch.now_s() + 0.5;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

/// How the fleet has ended: as the worst of its members.
RunEnding ending_of(const FleetStartOptions& options,
                    const MemberProcesses& members,
                    const fleet::FleetState& state,
                    const fleet_member::TeamPicture& picture,
                    const fs::path& out) {
  const std::string first_map = latest_map(state, members.names().front());
  const auto joined = static_cast<std::size_t>(
      std::count_if(state.robots.begin(), state.robots.end(), [&](const fleet::FleetRobot& robot) {
        return picture.relative_pose(first_map, robot).has_value();
      }));
  const std::vector<std::string> unfinished = members.unfinished();
  RunEnding ending;
  ending.next = console::shell_line({"echomap",
                                     "eval",
                                     (out / "team").string(),
                                     "--truth",
                                     truth_folder(out, members.names().front()).string()});
  if (console::interrupted()) {
    ending.outcome = "interrupted";
    ending.code = ExitCode::kInterrupted;
    ending.why = "interrupted";
  } else if (joined < members.names().size()) {
    ending.outcome = "not-joined";
    ending.code = ExitCode::kUnfinished;
    ending.why = fmt::format("{} of {} maps are one; how the others lie to it was never sure{}{}",
                             joined,
                             members.names().size(),
                             unfinished.empty() ? "" : "; unfinished: ",
                             fmt::join(unfinished, ", "));
  } else if (!unfinished.empty()) {
    ending.outcome = "unfinished";
    ending.code = ExitCode::kUnfinished;
    ending.why =
        fmt::format("the maps are one, but not all robots got what they were asked for: {}",
                    fmt::join(unfinished, ", "));
  } else {
    ending.outcome = "complete";
    ending.why = fmt::format("{} robots have one map of {}", joined, options.robot.world);
  }
  if (!unfinished.empty()) {
    ending.next =
        "see " +
        (out / unfinished.front().substr(0, unfinished.front().find(' ')) / "join.log").string();
  }
  return ending;
}

/// What the fleet has found, by the robots that say so: each is scored by the truth of its own map,
/// and told on the map of the first robot.
nlohmann::ordered_json source_findings(const fleet::FleetState& state,
                                       const fleet_member::TeamPicture& picture,
                                       const std::string& first_map,
                                       const fs::path& out) {
  auto findings = nlohmann::ordered_json::array();
  for (const fleet::FleetRobot& robot : state.robots) {
    if (!robot.search || robot.search->verdict == source_search::SourceVerdict::kUndecided) {
      continue;
    }
    auto finding = told_report({robot.name, *robot.search, robot.search->at_m});
    finding["found_radius_m"] = source_search::SourceBeliefParams().found_radius_m;
    if (robot.search_map_number == 0) {
      add_source_truth(truth_folder(out, robot.name) / "source.json", finding);
    }
    const auto relative = picture.team().relative_pose(
        first_map, fleet_member::map_name(robot.name, robot.search_map_number));
    if (robot.search->verdict == source_search::SourceVerdict::kFound) {
      const Eigen::Vector2d at_m =
          relative ? relative->T_own_peer * robot.search->at_m : Eigen::Vector2d::Zero();
      finding["best_m"] =
          relative ? nlohmann::ordered_json{at_m.x(), at_m.y()} : nlohmann::ordered_json();
    }
    findings.push_back(std::move(finding));
  }
  return findings;
}

/// How a fleet has ended that searches a source: as the first of it that is sure says, where nobody
/// says otherwise and none was lost.
RunEnding ending_of_fleet_search(const nlohmann::ordered_json& findings,
                                 bool has_lost_member,
                                 RunEnding maps) {
  if (maps.code == ExitCode::kInterrupted) {
    return maps;
  }
  if (findings.empty()) {
    if (maps.code == ExitCode::kOk) {
      maps.code = ExitCode::kUnfinished;
      maps.outcome = "unsure";
    }
    maps.why = "nobody was sure of a source; " + maps.why;
    return maps;
  }
  RunEnding ending = ending_of_search({}, findings.front(), {});
  const bool is_contradicted = std::ranges::any_of(findings, [&](const auto& finding) {
    return finding["verdict"] != findings.front()["verdict"];
  });
  if (is_contradicted || has_lost_member) {
    ending.code = ExitCode::kUnfinished;
    ending.outcome = is_contradicted ? "contradicted" : "member-lost";
    ending.why += is_contradicted ? "; another robot says otherwise" : "; a robot was lost";
  }
  ending.why += "; " + maps.why;
  ending.next = maps.next;
  return ending;
}

}  // namespace

ExitCode run_fleet_start(const FleetStartOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  const RunOptions& run = options.run;
  RobotProfile profile = profile_for(run.robot, run.strategy);
  if (options.search) {
    validate_searcher(profile);
  }
  const fs::path body = files::bundled_file(
      options.robot.body.empty() ? profile.name : options.robot.body, "hil_mock/robots", "body");
  const fs::path out = fs::absolute(run_folder(run.out));
  prepare_outputs(out, run.json, run.force);
  forget_earlier_run(out, robot_names(options.robot.robots));
  broker::Broker broker(broker_settings(options), out / "broker");
  console::print(fmt::format("broker of the fleet '{}' on port {}; observe it with --as {}",
                             kFleet,
                             broker.port(),
                             broker.credentials_file(kWatch).string()));
  session::SimulatedRobotOptions simulated = options.robot;
  simulated.driver = session::driver_of(profile.toml);
  const session::Seed seed(run.seed);
  session::SimulatedRobots robots(simulated, seed, body, out);
  FleetWatch watch(broker.credentials_file(kHub));
  FleetPage page(options.live, profile, out);
  fleet_member::TeamPicture picture;
  MemberProcesses members = start_members(options, broker, robots, out);
  look_on(members, broker, watch, picture, page);
  members.wait_for_all();
  watch.listen_for(0.5);
  picture.take_with_joins(watch.state());

  exports::RunSummary summary;
  summary.echomap_version = ECHOMAP_VERSION;
  summary.robot = profile.name;
  summary.world = options.robot.world;
  summary.seed = run.seed;
  RunEnding ending = ending_of(options, members, watch.state(), picture, out);
  nlohmann::ordered_json findings;
  const std::string map = latest_map(watch.state(), members.names().front());
  if (options.search) {
    findings = source_findings(watch.state(), picture, map, out);
    ending = ending_of_fleet_search(findings, members.has_lost_one(), std::move(ending));
  }
  describe_ending(ending, summary);
  summary.wall_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  auto report = nlohmann::ordered_json::parse(exports::to_json_text(summary));
  if (const auto snapshot = team_snapshot(picture, map)) {
    save_fleet_map(*snapshot, picture.team().merged(map), profile, out, summary);
    console::print("map: " + (out / "team" / "map.png").string());
    report["fleet"] = fleet_report(members.names(), watch, picture, out);
  }
  report["fleet"]["exits"] = members.exits();
  if (options.search) {
    report["source"] = findings;
  }
  write_report(out / "summary.json", report);
  write_report(run.json, report);
  print_ending(ending);
  page.end(watch.now_s(), ending);
  return ending.code;
}

}  // namespace echomap::apps
