// SPDX-License-Identifier: MIT
#include "host/apps/localize_run.hpp"

#include <memory>
#include <optional>
#include <random>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/apps/explore_run.hpp"
#include "host/apps/link_report.hpp"
#include "host/apps/live_run.hpp"
#include "host/apps/localize_view.hpp"
#include "host/apps/map_file.hpp"
#include "host/apps/recorded_run.hpp"
#include "host/apps/report.hpp"
#include "host/apps/run_ending.hpp"
#include "host/apps/run_recording.hpp"
#include "host/apps/run_words.hpp"
#include "host/apps/saved_map.hpp"
#include "host/apps/session_progress.hpp"
#include "host/console/print.hpp"
#include "host/exploration/nxt_rounds.hpp"
#include "host/exports/trajectory_tum.hpp"
#include "host/pipeline/preset_names.hpp"
#include "host/session/firmware_name.hpp"
#include "host/session/open_robot.hpp"
#include "host/session/pipeline_setup.hpp"
#include "host/session/robot_profile.hpp"
#include "host/strategies/strategy_setup.hpp"
#include "host/tracking/ekf_filter.hpp"
#include "host/tracking/mcl_filter.hpp"
#include "host/tracking/stop_driver.hpp"
#include "host/tracking/strategy_drive.hpp"

namespace echomap::apps {
namespace {

using nlohmann::ordered_json;
using session::RobotProfile;
using strategies::StrategyOptions;

/// Of a filter's particles, so many show how they lie.
constexpr std::size_t kRecordedPoses = 500;
/// Where no other number is named.
constexpr std::size_t kUsualStops = 20;

std::unique_ptr<tracking::LiveFilter> filter_for(const LocalizeOptions& options,
                                                 const RobotProfile& profile,
                                                 const std::optional<mapping::RasterMap>& map,
                                                 const session::Seed& seed) {
  if (!map) {
    return std::make_unique<tracking::EkfFilter>(
        profile.geometry,
        tracking::FixStream(tracking::open_fixes(options.fixes)),
        tracking::pose_option(options.camera_at).value_or(geometry::Pose2()),
        tracking::start_pose(options.at));
  }
  return std::make_unique<tracking::MclFilter>(*map,
                                               profile.geometry,
                                               localizer_params(profile, options),
                                               tracking::start_pose(options.at),
                                               seed.generator(session::SeedPurpose::kLocalizer));
}

/// What became of a drive, and where the robot was at its stops.
class Account {
 public:
  Account(const LocalizeOptions& options, const RobotProfile& profile) {
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
    json_["stops"].back()["sim_seconds"] = now_s(robot.context.session());
  }
  void describe(const std::optional<diagnosis::Diagnosis>& diagnosis) {
    json_["robot_fault"] = exports::to_json(summary_of(diagnosis));
  }
  void save(const RunEnding& ending, const FollowedRobot& robot, const std::filesystem::path& out) {
    json_.update(to_json(ending));
    json_["sim_seconds"] = now_s(robot.context.session());
    if (const auto& described = robot.context.session().link().robot();
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
  ordered_json json_;
};

/// The words that name robot and map; where it starts is another one each time.
console::CommandWords words_of(const LocalizeOptions& options) {
  console::CommandWords words{"echomap", "localize"};
  for (const std::string& port : options.connection.ports) {
    words.insert(words.end(), {"--port", port});
  }
  const console::CommandWords robot = robot_words(options.run);
  words.insert(words.end(), robot.begin(), robot.end());
  if (options.filter == "mcl") {
    words.insert(words.end(), {"--map", options.map.string()});
  } else {
    words.insert(words.end(), {"--filter", options.filter, "--fixes", options.fixes});
  }
  return words;
}

RunEnding ending_of_drive(const session::RobotContext& context,
                          const FollowedRobot& robot,
                          localization::LocalizerPreset preset,
                          const console::CommandWords& localize) {
  const auto found = context.diagnosis();
  if (found && forbids_a_map(found->fault.kind)) {
    return ending_of_fault(advice_of(found->fault, context.profile()),
                           console::shell_line(localize));
  }
  const std::string again = console::shell_line(localize);
  if (const auto end = robot.context.session().end()) {
    return ending_of(*end, robot.context.session().end_reason(), {again, again, again, again});
  }
  const auto finished = robot.driver.finished().value_or(exploration::FinishReason::kStopLimit);
  if (is_trouble(finished)) {
    return ending_of(finished, std::nullopt, std::nullopt, {again, again, again, again});
  }
  RunEnding ending = ending_of_preset(
      preset,
      ending_of_localization(exploration::name_of(finished), robot.filter.report(), localize),
      localize);
  return found ? with_fault(std::move(ending), advice_of(found->fault, context.profile())) : ending;
}

/// The map that the robot is looked for in, and where the filter has it.
void show(LiveRun& live, const std::optional<mapping::RasterMap>& map, const FollowedRobot& robot) {
  auto source = std::make_unique<FilterSource>(
      robot.filter, map ? std::optional(as_grid(*map)) : std::nullopt, [&driver = robot.driver] {
        return driver.intent();
      });
  PersonsWord word;
  if (auto* mcl = dynamic_cast<tracking::MclFilter*>(&robot.filter)) {
    word = {.moved = [mcl] { mcl->report_moved(); },
            .placed = [mcl](const geometry::Pose2& T_map_robot) { mcl->place(T_map_robot); }};
  }
  live.show(std::move(source), word);
}

/// With the map on the terminal where that is asked for.
void drive(session::RobotContext& context,
           const FollowedRobot& robot,
           const std::optional<mapping::RasterMap>& map,
           const RunOptions& run,
           Account& account) {
  const auto is_fit = [&] {
    const auto found = context.diagnosis();
    return !found || !forbids_a_map(found->fault.kind);
  };
  std::optional<LocalizeView> view;
  std::optional<SessionProgress> progress;
  if (map && progress_display(run) == ProgressDisplay::kMap) {
    view.emplace(context, robot.filter, *map);
    progress.emplace(context, *view, ProgressDisplay::kMap);
  }
  const std::size_t max_stops = run.strategy.stops.value_or(kUsualStops);
  while (account.stops() < max_stops && is_fit() && follow_to_next_stop(robot)) {
    account.add_stop(robot);
  }
  if (progress) {
    progress->finish();
  }
}

/// A robot with a sonar sweeps at stops; others feel their way as their strategy has it.
StrategyOptions strategy_for(const RobotProfile& profile, const LocalizeOptions& options) {
  StrategyOptions strategy = options.run.strategy;
  strategy.stops.reset();  // `drive` counts them.
  const bool is_named = strategy.name != StrategyOptions().name;
  if (profile.has_sonar && is_named) {
    throw CommandError(ExitCode::kUsage,
                       "--strategy " + strategy.name +
                           " does not localize a robot with a sonar, "
                           "which drives from stop to stop\n  next: leave --strategy out");
  }
  if (!profile.has_sonar && !is_named) {
    strategy.name = strategies::strategy_without_sonar(profile);
  }
  return strategy;
}

/// By a map of its own from stop to stop; else by a strategy that needs none.
bool is_driven_by_map(const RobotProfile& profile, localization::LocalizerPreset preset) {
  return profile.has_sonar && preset != localization::LocalizerPreset::kNxt;
}

/// Of a robot in the simplest way of its preset: the paper's rounds, stops chosen by what they
/// would tell, or a drive by what it feels.
std::unique_ptr<tracking::LocalizationDrive> drive_for(session::RobotContext& context,
                                                       const LocalizeOptions& options,
                                                       const StrategyOptions& strategy,
                                                       const tracking::LiveFilter& filter,
                                                       std::mt19937& random) {
  const RobotProfile& profile = context.profile();
  if (options.preset == localization::LocalizerPreset::kNxt) {
    return std::make_unique<tracking::StrategyDrive>(context, [&profile] {
      exploration::NxtRoundsParams params;
      params.pan_limit_rad = profile.pan_limit_rad;
      params.settle_s = profile.settle_s;
      return strategies::under_watch(
          std::make_unique<exploration::NxtRounds>(params), profile, false);
    });
  }
  if (is_driven_by_map(profile, options.preset)) {
    return std::make_unique<tracking::StopDriver>(
        context, options.run.slam, [&filter](const geometry::Pose2& goal) {
          return filter.telling(goal);
        });
  }
  return std::make_unique<tracking::StrategyDrive>(context, [&profile, strategy, &random] {
    return strategies::explorer_for(profile, strategy, random);
  });
}

}  // namespace

void set_filter(const LocalizeOptions& options, pipeline::RobotLocalizerParams& params) {
  params.preset = options.preset;
  params.particles = options.particles;
  params.resampling_share = options.resampling_share;
}

pipeline::RobotLocalizerParams localizer_params(const RobotProfile& profile,
                                                const LocalizeOptions& options) {
  pipeline::RobotLocalizerParams params = tracking::localizer_params(profile, options.preset);
  set_filter(options, params);
  return params;
}

bool follow_to_next_stop(const FollowedRobot& robot) {
  if (!robot.driver.go_to_next_stop()) {
    return false;
  }
  console::print("  " + robot.filter.line());
  if (!robot.filter.trajectory().empty()) {
    robot.context.recorder().add_localization(robot.filter.trajectory().back().T_map_robot,
                                              robot.filter.sampled_poses(kRecordedPoses));
  }
  if (robot.filter.has_lost_it()) {
    robot.driver.begin_new_map(1);
  }
  return true;
}

ExitCode localize_robot(const LocalizeOptions& options, const std::filesystem::path& out) {
  const RunOptions& run = options.run;
  RobotProfile profile = session::load_robot_profile(run.robot);
  const StrategyOptions strategy = strategy_for(profile, options);
  strategies::validate_fit(profile, strategy);
  const bool drives_by_map = is_driven_by_map(profile, options.preset);
  session::RobotContext context(std::move(profile), session::Seed(run.seed));
  const auto map = options.filter == "mcl" ? std::optional(read_map(options.map)) : std::nullopt;
  auto made = filter_for(options, context.profile(), map, context.seed());
  tracking::LiveFilter& filter = *made;
  LiveRun live(options.live, context, {.command = kLocalizeCommand, .out = out});
  context.follow(std::move(made));
  session::OpenedRobot opened = session::open_robot(options.connection, context.seed());
  opened.connection.may_be_lifted = true;
  context.open(std::move(opened));
  std::mt19937 random = context.seed().generator(session::SeedPurpose::kStrategy);
  const auto driver = drive_for(context, options, strategy, filter, random);
  const FollowedRobot robot{context, *driver, filter};

  Account account(options, context.profile());
  if (context.lockstep() != nullptr) {
    account.describe(context.lockstep()->device());
  }
  context.connect();
  exports::RunSummary facts;
  facts.slam = drives_by_map ? run.slam : session::kNoSlam;
  move_earlier_run_aside(out);
  begin_recording(context, kLocalizeCommand, facts, out, split_bytes(run));
  show(live, map, robot);
  drive(context, robot, map, run, account);
  live.show_nothing();
  context.session().disarm();
  account.describe(context.diagnosis());
  const RunEnding ending = ending_of_drive(context, robot, options.preset, words_of(options));
  account.save(ending, robot, out);
  end_recording(context, account.json(), out);
  write_report(run.json, account.json());
  context.quit();
  console::print(fmt::format("{} stops: {}", account.stops(), filter.line()));
  console::print("trajectory: " + (out / "trajectory.tum").string());
  print_ending(ending, "the trajectory so far");
  live.end(ending);
  return ending.code;
}

}  // namespace echomap::apps
