// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "host/exploration/active_localization.hpp"
#include "host/exploration/explorer.hpp"
#include "host/exploration/frontier.hpp"
#include "host/exploration/navigator.hpp"
#include "host/exploration/nxt_farthest.hpp"
#include "host/exploration/stop_tour.hpp"
#include "host/exploration/tangent_bug.hpp"
#include "host/session/robot_profile.hpp"

namespace echomap::strategies {

/// How to explore, as the command line names it.
struct StrategyOptions {
  std::string name = "frontier";
  std::optional<std::size_t> stops;  ///< At most; empty: as many as it takes.
  std::size_t scans = 1;             ///< Of the room, by nxt-farthest.
  std::string waypoints;  ///< Course of tangent-bug: a bundled name or a TOML file; empty: none.
  std::string stop_list;  ///< Places of stops: a TOML file; empty: none.
  std::string hand = "right";  ///< Or "left": which is held to the wall.
  /// Leaves out departures of nxt-farthest, coastal and tangent-bug from their papers.
  bool as_told = false;
  double seconds = 120.0;  ///< How long random-bounce drives.
};

/// What of the options ends an exploration at the latest.
enum class StrategyLimit : std::uint8_t { kNone, kStops, kSeconds };

/// A way to explore that `--strategy` names.
struct Strategy {
  const char* name;
  /// What it needs and the profile has not, as "a sonar"; empty where nothing lacks.
  std::function<std::string(const session::RobotProfile& profile, const StrategyOptions& options)>
      lack;
  /// Keeps a reference to `random`. Throws files::ConfigError for a file that the options name.
  std::function<std::unique_ptr<exploration::Explorer>(
      const session::RobotProfile& profile, const StrategyOptions& options, std::mt19937& random)>
      make;
  /// It sees to it that its ways are clear, so that the danger checker does not shorten them.
  bool checks_its_ways = false;
  StrategyLimit limit = StrategyLimit::kNone;
  /// It goes by nothing but the map, so that it can start again in another one.
  bool begins_anywhere = false;
};

/// In the order of the help.
const std::vector<Strategy>& strategies();
std::vector<std::string> strategy_names();

/// That of the strategy of the options. Throws CommandError where there is no such strategy.
StrategyLimit limit_of(const StrategyOptions& options);

/// Whether the strategy of the options does.
bool begins_anywhere(const StrategyOptions& options);

/// The strategy of the options, for a robot, under the eyes of a danger checker. Throws
/// CommandError where the robot lacks what it needs, and as `Strategy::make`.
std::unique_ptr<exploration::Explorer> explorer_for(const session::RobotProfile& profile,
                                                    const StrategyOptions& options,
                                                    std::mt19937& random);
/// A strategy under the eyes of a danger checker and a fault watch; `checks_its_ways` as of a
/// Strategy.
std::unique_ptr<exploration::Explorer> under_watch(std::unique_ptr<exploration::Explorer> explorer,
                                                   const session::RobotProfile& profile,
                                                   bool checks_its_ways);
/// Throws CommandError where the robot lacks what the strategy of the options needs.
void validate_fit(const session::RobotProfile& profile, const StrategyOptions& options);

/// The name of the strategy by which a robot without a sonar drives where none is named: along
/// walls with a ring of infra-red sensors, else from bump to bump.
std::string strategy_without_sonar(const session::RobotProfile& profile);

/// What leads a robot over its map has to know of it.
exploration::NavigatorParams navigator_params(const session::RobotProfile& profile);

/// What nxt-farthest has to know of a robot; without `max_stops` it makes as many as it takes.
exploration::NxtFarthestParams nxt_farthest_params(const session::RobotProfile& profile,
                                                   std::optional<std::size_t> max_stops);
/// The same without the spread of the four candidates and without a memory of stops (Singh and Bedi
/// 2013, section 3.2).
exploration::NxtFarthestParams as_told(exploration::NxtFarthestParams params);

/// What tangent-bug has to know of a robot.
exploration::TangentBugParams tangent_bug_params(const session::RobotProfile& profile);

/// What frontier has to know of a robot; without `max_stops` it makes as many as it takes.
exploration::FrontierParams frontier_params(const session::RobotProfile& profile,
                                            std::optional<std::size_t> max_stops);

/// What the search for the robot's place has to know of a robot.
exploration::ActiveLocalizationParams active_localization_params(
    const session::RobotProfile& profile);

/// What stops has to know of a robot.
exploration::StopTourParams stop_tour_params(const session::RobotProfile& profile);

}  // namespace echomap::strategies
