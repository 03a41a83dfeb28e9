// SPDX-License-Identifier: MIT
#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <spdlog/spdlog.h>

#include "host/apps/commands.hpp"
#include "host/apps/counted_encounters.hpp"
#include "host/apps/explore_run.hpp"
#include "host/apps/fleet_connection.hpp"
#include "host/apps/fleet_map_files.hpp"
#include "host/apps/live_run.hpp"
#include "host/apps/member_report.hpp"
#include "host/apps/report.hpp"
#include "host/apps/run_recording.hpp"
#include "host/apps/source_report.hpp"
#include "host/apps/source_setup.hpp"
#include "host/console/interrupt.hpp"
#include "host/console/print.hpp"
#include "host/console/shell_line.hpp"
#include "host/fleet/fleet_rounds.hpp"
#include "host/fleet_member/fleet_member.hpp"
#include "host/fleet_member/team_searcher.hpp"
#include "host/geometry/angle.hpp"
#include "host/mqtt/fleet_name.hpp"
#include "host/team_exploration/team_explorer.hpp"

namespace echomap::apps {
namespace {

namespace fs = std::filesystem;
using fleet_member::FleetMember;
using fleet_member::FleetMemberParams;
using session::RobotContext;

/// Simulated seconds of a round.
constexpr double kRoundS = 0.5;
/// Of a simulated fleet, whose broker is new for each run.
constexpr std::uint32_t kSimulatedBoot = 1;
/// What has been made is out long before.
constexpr std::chrono::seconds kFarewell{20};

double wall_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::uint32_t seconds_since_1970() {
  const auto since = std::chrono::system_clock::now().time_since_epoch();
  return static_cast<std::uint32_t>(
      std::chrono::duration_cast<std::chrono::seconds>(since).count());
}

bool is_in_rounds(const FleetJoinOptions& options) { return !options.rounds_with.empty(); }

FleetMemberParams member_params(const FleetJoinOptions& options,
                                const broker::Credentials& credentials,
                                const session::RobotProfile& profile) {
  const bool in_rounds = is_in_rounds(options);
  FleetMemberParams params;
  params.exchange.fleet = credentials.fleet;
  params.exchange.robot = credentials.user;
  params.exchange.boot_id = in_rounds ? kSimulatedBoot : seconds_since_1970();
  params.exchange.traits = {profile.body_radius_m, profile.beam_half_angle_rad};
  params.echoes.beam_half_angle_rad = profile.beam_half_angle_rad;
  params.echoes.robot_radius_m = profile.body_radius_m;
  if (in_rounds) {
    params.exchange_period_s = kRoundS;
  } else {
    params.exchange.folder = fs::path(options.as).replace_extension("told");
  }
  if (options.search) {
    params.source = source_readings_params(profile);
  }
  return params;
}

/// Waits for the end of a round; throws where somebody has had enough.
void wait_for_round(fleet::FleetRounds& rounds) {
  while (!rounds.poll(wall_s())) {
    if (console::interrupted()) {
      throw CommandError(ExitCode::kInterrupted, "interrupted while it waited for the fleet");
    }
    std::this_thread::sleep_for(std::chrono::microseconds(300));
  }
}

/// Each exchange of a simulated fleet ends a round; the user of a real one hears of the connection.
void follow_bus(FleetMember& member, fleet::FleetRounds* rounds, const mqtt::Connection& bus) {
  if (rounds == nullptr) {
    member.after_exchange = [&bus, news = ConnectionNews()]() mutable { news.tell(bus); };
    return;
  }
  const auto end_round = [rounds] {
    rounds->end_round();
    wait_for_round(*rounds);
  };
  member.after_exchange = end_round;
  end_round();
}

/// What drives a member: `frontier` among others.
std::unique_ptr<exploration::Explorer> team_explorer(FleetMember& member,
                                                     const session::RobotProfile& profile,
                                                     const std::string& name,
                                                     const strategies::StrategyOptions& left,
                                                     MemberEncounters& encounters) {
  team_exploration::TeamExplorerParams params;
  params.frontier = strategies::frontier_params(profile, left.stops);
  params.avoidance.robot = name;
  params.avoidance.navigator = params.frontier.navigator;
  params.avoidance.guard.robot_radius_m = profile.body_radius_m;
  params.avoidance.aside.costs = params.frontier.navigator.costs;
  return strategies::under_watch(
      std::make_unique<CountedEncounters<team_exploration::TeamExplorer>>(
          encounters, member, params),
      profile,
      true);
}

/// What a member searches a source with.
struct MemberSearch {
  explicit MemberSearch(const session::RobotProfile& profile)
      : readings(source_readings_params(profile)) {}

  source_search::SourceReadings readings;
  std::shared_ptr<source_search::SourceSearch> strategy;
};

/// What drives a member that searches a source.
std::unique_ptr<exploration::Explorer> team_searcher(FleetMember& member,
                                                     MemberSearch& search,
                                                     const session::RobotProfile& profile,
                                                     const std::string& name,
                                                     double max_s,
                                                     MemberEncounters& encounters) {
  const source_search::SourceSearchParams source = source_search_params(profile);
  fleet_member::TeamSearcherParams params;
  params.max_s = max_s;
  params.avoidance.robot = name;
  params.avoidance.navigator = source.frontier.navigator;
  params.avoidance.guard.robot_radius_m = profile.body_radius_m;
  params.avoidance.aside.costs = source.frontier.navigator.costs;
  search.strategy = std::make_shared<source_search::SourceSearch>(source);
  return strategies::under_watch(std::make_unique<CountedEncounters<fleet_member::TeamSearcher>>(
                                     encounters, member, search.strategy, search.readings, params),
                                 profile,
                                 true);
}

/// Writes what the fleet has found into the run; answers how the search has ended.
RunEnding report_on_team_search(FleetMember& member,
                                const MemberSearch& search,
                                const RunEnding& drive,
                                const ExploreRun& run,
                                nlohmann::ordered_json& report) {
  const auto* strategy = search.strategy.get();
  const auto* belief = strategy != nullptr ? strategy->belief() : nullptr;
  nlohmann::ordered_json source = source_report(belief);
  const bool is_own = strategy != nullptr && strategy->has_ended();
  if (const auto told = member.search_view().finding; told && !is_own) {
    source = told_report(*told);
  }
  report["source"] = source;
  report["strategy"] = "source";
  write_report(run.out / "source.json", source);
  if (belief != nullptr) {
    write_source_density(run.out / "source_density.csv", *belief);
  }
  return ending_of_search(drive, source, run.next);
}

/// Where the map of another robot lies in this one's.
struct KnownPose {
  std::string peer;
  team_map::RelativePose relative;
};

/// "NAME,X,Y,DEGREES".
KnownPose known_pose(const std::string& words, const std::string& own_name) {
  const std::size_t comma = words.find(',');
  double x_m = 0.0;
  double y_m = 0.0;
  double heading_deg = 0.0;
  char end = 0;
  if (comma == std::string::npos || !mqtt::is_fleet_name(words.substr(0, comma)) ||
      std::sscanf(words.c_str() + comma, ",%lf,%lf,%lf%c", &x_m, &y_m, &heading_deg, &end) != 3 ||
      !std::isfinite(x_m + y_m + heading_deg)) {
    throw CommandError(
        ExitCode::kUsage,
        "--knows is NAME,X,Y,DEGREES, not '" + words + "'\n  next: echomap fleet join --help");
  }
  const std::string peer = words.substr(0, comma);
  if (peer == own_name) {
    throw CommandError(
        ExitCode::kUsage,
        "--knows " + words + " is this robot itself\n  next: name another robot of the fleet");
  }
  return {peer, {geometry::Pose2(x_m, y_m, geometry::radians(heading_deg)), 0.02, 0.02}};
}

std::vector<KnownPose> known_poses(const FleetJoinOptions& options, const std::string& own_name) {
  std::vector<KnownPose> known;
  known.reserve(options.knows.size());
  for (const std::string& words : options.knows) {
    known.push_back(known_pose(words, own_name));
  }
  return known;
}

/// Says good-bye, and stays until all that it has made is out; how many messages are not.
std::size_t part(FleetMember& member,
                 fleet::FleetRounds* rounds,
                 mqtt::Connection& bus,
                 double now_s) {
  member.leave();
  member.after_exchange = nullptr;
  member.exchange(now_s);
  if (rounds != nullptr) {
    rounds->end_round(true);
  }
  const double begin_s = wall_s();
  const auto passed_s = [&] { return wall_s() - begin_s; };
  while (passed_s() < static_cast<double>(kFarewell.count()) && !console::interrupted() &&
         (member.fleet().unconfirmed() > 0 || bus.unacknowledged() > 0)) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    if (rounds == nullptr) {
      member.exchange(now_s + passed_s());
      continue;
    }
    rounds->poll(wall_s());
    bus.take();
    if (bus.unacknowledged() == 0) {
      break;
    }
    member.exchange(now_s);
  }
  bus.disconnect();
  return rounds == nullptr ? member.fleet().unconfirmed() : 0;
}

/// How a run has ended of which the others do not know all, or would not if the broker lost it.
void add_untold(std::size_t untold, const FleetMember& member, RunEnding& ending) {
  if (untold > 0) {
    ending.why += fmt::format("; the broker has not taken {} messages of it", untold);
  }
  if (member.unsendable_stops() > 0) {
    ending.why +=
        fmt::format("; {} stops were too large to be sent, so that others miss what follows",
                    member.unsendable_stops());
  }
  if (const std::size_t unsaved = member.fleet().statistics().unsaved; unsaved > 0) {
    ending.why += fmt::format("; {} messages could not be kept in its folder", unsaved);
  }
  const bool is_known = untold + member.unsendable_stops() == 0;
  if (!is_known && ending.code == ExitCode::kOk) {
    ending.code = ExitCode::kUnfinished;
    ending.outcome = "untold";
  }
}

void refuse_other_strategies(const strategies::StrategyOptions& strategy) {
  if (strategy.name != "frontier") {
    throw CommandError(ExitCode::kUsage,
                       "a member of a fleet explores by --strategy frontier, not by " +
                           strategy.name + "\n  next: leave --strategy out");
  }
}

NextCommands next_of(const FleetJoinOptions& options, const std::filesystem::path& out) {
  const auto line = [](const console::CommandWords& words) { return console::shell_line(words); };
  const fs::path watch = fs::path(options.as).replace_filename("watch.toml");
  const std::string as = (exists(watch) ? watch : fs::path(options.as)).string();
  const std::string map = line({"echomap", "fleet", "map", "--as", as});
  const std::string localize = line({"echomap", "localize", "--map", (out / "team").string()});
  const std::string again = line({"echomap", "fleet", "join", "--as", options.as.string()});
  return {map, again, localize, again};
}

}  // namespace

ExitCode run_fleet_join(const FleetJoinOptions& options) {
  const RunOptions& run = options.run;
  refuse_other_strategies(run.strategy);
  session::RobotProfile profile = profile_for(run.robot, run.strategy);
  std::optional<MemberSearch> search;
  if (options.search) {
    validate_searcher(profile);
    search.emplace(profile);
  }
  RobotContext robot(std::move(profile), session::Seed(run.seed));
  if (search) {
    robot.fork().add(search->readings);
  }
  const auto out = run_folder(run.out);
  LiveRun live({}, robot, {.command = "fleet join", .out = out});
  begin_maps(robot, "", run.slam);
  prepare_outputs(out, run.json, run.force);
  exports::RunSummary summary;

  const broker::Credentials credentials = broker::read_credentials(options.as);
  const std::vector<KnownPose> known = known_poses(options, credentials.user);
  const FleetMemberParams params = member_params(options, credentials, robot.profile());
  const FleetConnection connection =
      connect_to_fleet(options.as, fleet::last_will(params.exchange));
  std::optional<fleet::FleetRounds> rounds;
  if (is_in_rounds(options)) {
    rounds.emplace(*connection.bus,
                   fleet::FleetRoundsParams{
                       credentials.fleet, credentials.user, kSimulatedBoot, options.rounds_with});
  }
  mqtt::MessageBus& bus = rounds ? static_cast<mqtt::MessageBus&>(*rounds) : *connection.bus;
  FleetMember member(robot, bus, params);
  for (const auto& [peer, relative] : known) {
    member.set_known_pose(peer, relative);
  }
  follow_bus(member, rounds ? &*rounds : nullptr, *connection.bus);
  open_port(robot, options.connection, run.strategy, summary);
  ExploreRun explore{run.strategy, live, out, progress_display(run), run.align, split_bytes(run)};
  explore.next = next_of(options, out);
  MemberEncounters encounters;
  explore.make_explorer = [&](const strategies::StrategyOptions& left) {
    const session::RobotProfile& whose = robot.profile();
    const std::string& name = credentials.user;
    return search ? team_searcher(member, *search, whose, name, options.max_s, encounters)
                  : team_explorer(member, whose, name, left, encounters);
  };
  explore.known = [&] { return member.known(); };
  RunEnding ending = explore_and_save(robot, explore, summary);
  const double end_s = session::now_s(robot.session());
  const std::size_t untold = part(member, rounds ? &*rounds : nullptr, *connection.bus, end_s);
  save_team_map(member, robot.profile(), out / "team", summary);
  robot.quit();
  auto report = nlohmann::ordered_json::parse(exports::to_json_text(summary));
  if (search) {
    ending = report_on_team_search(member, *search, ending, explore, report);
  }
  add_untold(untold, member, ending);
  warn_of_refused(member.fleet().statistics().received);
  report["outcome"] = ending.outcome;
  report["why"] = ending.why;
  end_recording(robot, report, out);
  report["team"] = team_report(member.joins(), encounters);
  write_report(out / "summary.json", report);
  write_report(run.json, report);
  print_ending(ending);
  return ending.code;
}

}  // namespace echomap::apps
