// SPDX-License-Identifier: MIT
#include "host/strategies/strategy_setup.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "host/console/exit_code.hpp"
#include "host/exploration/danger_checker.hpp"
#include "host/exploration/epuck_drive.hpp"
#include "host/exploration/fault_watch.hpp"
#include "host/exploration/random_bounce.hpp"
#include "host/files/bundled_files.hpp"
#include "host/geometry/angle.hpp"
#include "host/strategies/coastal_setup.hpp"
#include "host/strategies/course_file.hpp"
#include "host/strategies/stop_list_file.hpp"

namespace echomap::strategies {
namespace {

using console::CommandError;
using console::ExitCode;
using session::RobotProfile;

constexpr std::size_t kNoLimit = std::numeric_limits<std::size_t>::max();

using ExplorerPtr = std::unique_ptr<exploration::Explorer>;

std::string lack_of_sonar(const RobotProfile& profile, const StrategyOptions& /*options*/) {
  return profile.has_sonar ? "" : "a sonar";
}

/// No slower at an obstacle than the robot drives at all.
exploration::PathFollowerParams follower_params(const RobotProfile& profile) {
  exploration::PathFollowerParams params;
  params.speed_m_per_s = profile.speed_m_per_s;
  params.min_speed_m_per_s = std::min(params.min_speed_m_per_s, profile.speed_m_per_s);
  return params;
}

ExplorerPtr make_nxt_farthest(const RobotProfile& profile,
                              const StrategyOptions& options,
                              std::mt19937& random) {
  auto params = nxt_farthest_params(profile, options.stops);
  params.scans = options.scans;
  return std::make_unique<exploration::NxtFarthest>(options.as_told ? as_told(params) : params,
                                                    random);
}

ExplorerPtr make_tangent_bug(const RobotProfile& profile,
                             const StrategyOptions& options,
                             std::mt19937& /*random*/) {
  if (options.waypoints.empty()) {
    throw CommandError(ExitCode::kUsage,
                       "strategy 'tangent-bug' needs waypoints\n"
                       "  next: --waypoints playground, or a TOML file of your room");
  }
  const exploration::TangentBugParams ours = tangent_bug_params(profile);
  return std::make_unique<exploration::TangentBug>(
      options.as_told ? exploration::as_printed(ours) : ours, load_course(options.waypoints));
}

ExplorerPtr make_frontier(const RobotProfile& profile,
                          const StrategyOptions& options,
                          std::mt19937& /*random*/) {
  return std::make_unique<exploration::Frontier>(frontier_params(profile, options.stops));
}

ExplorerPtr make_stop_tour(const RobotProfile& profile,
                           const StrategyOptions& options,
                           std::mt19937& /*random*/) {
  if (options.stop_list.empty()) {
    throw CommandError(ExitCode::kUsage,
                       "strategy 'stops' needs a list of places\n"
                       "  next: --stop-list FILE, a TOML file as in docs/algorithms/stop_tour.md");
  }
  return std::make_unique<exploration::StopTour>(stop_tour_params(profile),
                                                 load_stop_list(options.stop_list));
}

exploration::DangerCheckerParams danger_params(const RobotProfile& profile) {
  exploration::DangerCheckerParams params;
  params.robot_radius_m = profile.body_radius_m;
  params.costs.robot_radius_m = profile.body_radius_m;
  params.follower.speed_m_per_s = profile.speed_m_per_s;
  params.return_below_v = profile.return_below_v;
  params.stop_below_v = profile.stop_below_v;
  return params;
}

exploration::Hand hand_of(const StrategyOptions& options) {
  return options.hand == "left" ? exploration::Hand::kLeft : exploration::Hand::kRight;
}

std::string lack_of_wall_sensor(const RobotProfile& profile, const StrategyOptions& options) {
  return lack_for_coastal(profile, hand_of(options));
}

ExplorerPtr make_coastal(const RobotProfile& profile,
                         const StrategyOptions& options,
                         std::mt19937& /*random*/) {
  const exploration::CoastalParams ours = coastal_params(profile, hand_of(options));
  return std::make_unique<exploration::Coastal>(options.as_told ? as_told(ours) : ours);
}

/// Every board has contacts; without bumpers at them a wheel that stands says the same.
std::string lack_of_nothing(const RobotProfile& /*profile*/, const StrategyOptions& /*options*/) {
  return "";
}

ExplorerPtr make_random_bounce(const RobotProfile& profile,
                               const StrategyOptions& options,
                               std::mt19937& random) {
  exploration::RandomBounceParams params;
  params.speed_m_per_s = profile.speed_m_per_s;
  params.max_s = options.seconds;
  return std::make_unique<exploration::RandomBounce>(params, random);
}

std::string lack_of_infrared_ring(const RobotProfile& profile, const StrategyOptions& /*options*/) {
  const auto& ring = profile.sensors.infrared;
  const auto looks = [&](double from_deg, double to_deg) {
    return std::any_of(ring.begin(), ring.end(), [&](const sensors::InfraredSensor& sensor) {
      const double bearing_deg = geometry::degrees(sensor.T_robot_sensor.heading_rad());
      return bearing_deg >= from_deg && bearing_deg <= to_deg;
    });
  };
  return looks(-30.0, 30.0) && looks(-120.0, -76.0)
             ? ""
             : "infra-red sensors that look ahead and to the right";
}

ExplorerPtr make_epuck(const RobotProfile& profile,
                       const StrategyOptions& /*options*/,
                       std::mt19937& /*random*/) {
  exploration::EpuckDriveParams params;
  params.follower.speed_m_per_s = profile.speed_m_per_s;
  params.follower.robot_radius_m = profile.body_radius_m;
  for (const sensors::InfraredSensor& sensor : profile.sensors.infrared) {
    params.follower.T_robot_sensor.push_back(sensor.T_robot_sensor);
  }
  return std::make_unique<exploration::EpuckDrive>(params);
}

const Strategy& strategy_of(const StrategyOptions& options) {
  const auto& all = strategies();
  const auto found = std::find_if(
      all.begin(), all.end(), [&](const Strategy& one) { return one.name == options.name; });
  if (found == all.end()) {
    throw CommandError(ExitCode::kUsage, "unknown strategy '" + options.name + "'");
  }
  return *found;
}

/// An option that only some strategies go by.
struct OwnedOption {
  const char* name;
  bool is_asked_for;
  std::vector<std::string> owners;
};

std::vector<OwnedOption> owned_options(const StrategyOptions& options) {
  const StrategyOptions usual;
  std::vector<std::string> limited;
  for (const Strategy& strategy : strategies()) {
    if (strategy.limit == StrategyLimit::kStops) {
      limited.emplace_back(strategy.name);
    }
  }
  return {{"--stops", options.stops.has_value(), limited},
          {"--scans", options.scans > usual.scans, {"nxt-farthest"}},
          {"--waypoints", !options.waypoints.empty(), {"tangent-bug"}},
          {"--stop-list", !options.stop_list.empty(), {"stops"}},
          {"--hand", options.hand != usual.hand, {"coastal"}},
          {"--seconds", options.seconds != usual.seconds, {"random-bounce"}},
          {"--as-told", options.as_told, {"nxt-farthest", "coastal", "tangent-bug"}}};
}

bool fits(const RobotProfile& profile, StrategyOptions options, const std::string& strategy) {
  options.name = strategy;
  return strategy_of(options).lack(profile, options).empty();
}

/// What only another strategy goes by shall not do nothing in silence.
void refuse_strange_options(const RobotProfile& profile, const StrategyOptions& options) {
  for (const OwnedOption& option : owned_options(options)) {
    if (!option.is_asked_for || std::ranges::count(option.owners, options.name) > 0) {
      continue;
    }
    const auto owner = std::ranges::find_if(
        option.owners, [&](const std::string& one) { return fits(profile, options, one); });
    throw CommandError(ExitCode::kUsage,
                       std::string(option.name) + " is for strategy '" + option.owners.front() +
                           "', not for '" + options.name + "'\n  next: leave it out" +
                           (owner == option.owners.end() ? "" : ", or --strategy " + *owner));
  }
}

/// What to type where a robot lacks what the strategy needs: the option that it lacks nothing for,
/// a bundled robot that has it (the usual one before others), or a strategy that fits the robot.
std::string what_fits(const RobotProfile& profile, const StrategyOptions& options) {
  StrategyOptions other_hand = options;
  other_hand.hand = options.hand == "left" ? "right" : "left";
  if (fits(profile, other_hand, options.name)) {
    return "--hand " + other_hand.hand;
  }
  std::vector<std::string> robots = files::bundled_names("host/profiles");
  std::ranges::stable_partition(robots, [](const std::string& name) { return name == "uno_2wd"; });
  const auto robot = std::ranges::find_if(robots, [&](const std::string& name) {
    return fits(session::load_robot_profile(name), options, options.name);
  });
  const std::array<const char*, 4> names{"frontier", "coastal", "epuck", "random-bounce"};
  const auto* const strategy =
      std::ranges::find_if(names, [&](const char* name) { return fits(profile, {}, name); });
  return "--robot " + (robot == robots.end() ? "another" : *robot) + ", or --strategy " +
         *strategy + ", which '" + profile.name + "' can do";
}

}  // namespace

const std::vector<Strategy>& strategies() {
  static const std::vector<Strategy> all{
      {"nxt-farthest", lack_of_sonar, make_nxt_farthest, false, StrategyLimit::kStops, true},
      {"tangent-bug", lack_of_sonar, make_tangent_bug, true},
      {"frontier", lack_of_sonar, make_frontier, false, StrategyLimit::kStops, true},
      {"stops", lack_of_sonar, make_stop_tour},
      {"coastal", lack_of_wall_sensor, make_coastal},
      {"random-bounce", lack_of_nothing, make_random_bounce, false, StrategyLimit::kSeconds},
      {"epuck", lack_of_infrared_ring, make_epuck},
  };
  return all;
}

std::vector<std::string> strategy_names() {
  std::vector<std::string> names;
  for (const Strategy& strategy : strategies()) {
    names.emplace_back(strategy.name);
  }
  return names;
}

StrategyLimit limit_of(const StrategyOptions& options) { return strategy_of(options).limit; }

bool begins_anywhere(const StrategyOptions& options) {
  return strategy_of(options).begins_anywhere;
}

ExplorerPtr explorer_for(const RobotProfile& profile,
                         const StrategyOptions& options,
                         std::mt19937& random) {
  validate_fit(profile, options);
  const Strategy& strategy = strategy_of(options);
  return under_watch(strategy.make(profile, options, random), profile, strategy.checks_its_ways);
}

ExplorerPtr under_watch(ExplorerPtr explorer, const RobotProfile& profile, bool checks_its_ways) {
  exploration::DangerCheckerParams danger = danger_params(profile);
  danger.shortens_drives = !checks_its_ways;
  return std::make_unique<exploration::FaultWatch>(
      std::make_unique<exploration::DangerChecker>(std::move(explorer), danger));
}

void validate_fit(const RobotProfile& profile, const StrategyOptions& options) {
  refuse_strange_options(profile, options);
  const std::string lack = strategy_of(options).lack(profile, options);
  if (lack.empty()) {
    return;
  }
  throw CommandError(ExitCode::kConfigInvalid,
                     "strategy '" + options.name + "' needs " + lack + ", and profile '" +
                         profile.name + "' has none\n  next: " + what_fits(profile, options));
}

std::string strategy_without_sonar(const RobotProfile& profile) {
  return lack_of_infrared_ring(profile, {}).empty() ? "epuck" : "random-bounce";
}

exploration::NxtFarthestParams nxt_farthest_params(const RobotProfile& profile,
                                                   std::optional<std::size_t> max_stops) {
  exploration::NxtFarthestParams params;
  params.sweep.pan_limit_rad = profile.pan_limit_rad;
  params.sweep.settle_s = profile.settle_s;
  params.robot_radius_m = profile.body_radius_m;
  params.max_stops = max_stops.value_or(kNoLimit);
  return params;
}

exploration::NxtFarthestParams as_told(exploration::NxtFarthestParams params) {
  params.candidate_spread_rad = 0.0;
  params.stop_spacing_m = 0.0;
  return params;
}

exploration::TangentBugParams tangent_bug_params(const RobotProfile& profile) {
  exploration::TangentBugParams params;
  params.sweep.pan_limit_rad = profile.pan_limit_rad;
  params.sweep.settle_s = profile.settle_s;
  params.max_m = profile.range.max_range_m;
  params.robot_radius_m = profile.body_radius_m;
  params.beam_half_angle_rad = profile.beam_half_angle_rad;
  return params;
}

exploration::NavigatorParams navigator_params(const RobotProfile& profile) {
  exploration::NavigatorParams params;
  params.costs.robot_radius_m = profile.body_radius_m;
  params.follower = follower_params(profile);
  return params;
}

exploration::FrontierParams frontier_params(const RobotProfile& profile,
                                            std::optional<std::size_t> max_stops) {
  exploration::FrontierParams params;
  params.navigator = navigator_params(profile);
  double& faced_m = params.gain.unobserved.max_distance_m;
  faced_m = std::min(faced_m, session::sure_range_m(profile));
  params.doors.max_distance_m = std::min(params.doors.max_distance_m, faced_m);
  params.viewpoints.speed_m_per_s = profile.speed_m_per_s;
  params.sweep.pan_limit_rad = profile.pan_limit_rad;
  params.sweep.settle_s = profile.settle_s;
  params.max_stops = max_stops.value_or(kNoLimit);
  return params;
}

exploration::ActiveLocalizationParams active_localization_params(const RobotProfile& profile) {
  exploration::ActiveLocalizationParams params;
  params.navigator = navigator_params(profile);
  params.speed_m_per_s = profile.speed_m_per_s;
  params.sweep.pan_limit_rad = profile.pan_limit_rad;
  params.sweep.settle_s = profile.settle_s;
  return params;
}

exploration::StopTourParams stop_tour_params(const RobotProfile& profile) {
  exploration::StopTourParams params;
  params.costs.robot_radius_m = profile.body_radius_m;
  params.follower = follower_params(profile);
  params.sweep.pan_limit_rad = profile.pan_limit_rad;
  params.sweep.settle_s = profile.settle_s;
  return params;
}

}  // namespace echomap::strategies
