// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "host/apps/commands.hpp"
#include "host/apps/robot_profile.hpp"
#include "host/exploration/explorer.hpp"
#include "host/exploration/frontier.hpp"
#include "host/exploration/nxt_farthest.hpp"
#include "host/exploration/tangent_bug.hpp"
#include "host/pipeline/robot_atlas.hpp"
#include "host/pipeline/robot_pipeline.hpp"

namespace echomap::apps {

/// What of the options ends an exploration at the latest.
enum class StrategyLimit : std::uint8_t { kNone, kStops, kSeconds };

/// A way to explore that `--strategy` names.
struct Strategy {
  const char* name;
  /// What it needs and the profile has not, as "a sonar"; empty where nothing lacks.
  std::function<std::string(const RobotProfile& profile, const RunOptions& options)> lack;
  /// Keeps a reference to `random`. Throws files::ConfigError for a file that the options name.
  std::function<std::unique_ptr<exploration::Explorer>(
      const RobotProfile& profile, const RunOptions& options, std::mt19937& random)>
      make;
  /// It sees to it that its ways are clear, so that the danger checker does not shorten them.
  bool checks_its_ways = false;
  StrategyLimit limit = StrategyLimit::kNone;
  /// It goes by nothing but the map, so that it can begin anew in another one.
  bool begins_anywhere = false;
};

/// In the order of the help.
const std::vector<Strategy>& strategies();
std::vector<std::string> strategy_names();

/// What `--slam` says where the odometry alone places the robot.
inline constexpr const char* kNoSlam = "none";

/// What `--slam` of a robot that drives may be: the ways for sonars, and none.
std::vector<std::string> live_slam_names();

/// That of the strategy of the options. Throws CommandError where there is no such strategy.
StrategyLimit limit_of(const RunOptions& options);

/// Whether the strategy of the options does.
bool begins_anywhere(const RunOptions& options);

/// The strategy of the options, for a robot, under the eyes of a danger checker. Throws
/// CommandError where the robot lacks what it needs, and as `Strategy::make`.
std::unique_ptr<exploration::Explorer> explorer_for(const RobotProfile& profile,
                                                    const RunOptions& options,
                                                    std::mt19937& random);
/// Throws CommandError where the robot lacks what the strategy of the options needs.
void require_fit(const RobotProfile& profile, const RunOptions& options);

/// What nxt-farthest has to know of a robot.
exploration::NxtFarthestParams nxt_farthest_params(const RobotProfile& profile,
                                                   std::size_t most_stops);

/// What tangent-bug has to know of a robot.
exploration::TangentBugParams tangent_bug_params(const RobotProfile& profile);

/// What frontier has to know of a robot.
exploration::FrontierParams frontier_params(const RobotProfile& profile, std::size_t most_stops);

/// An empty pipeline for what the robot senses. SLAM of that name (RunOptions::slam) places a robot
/// with a sonar.
pipeline::RobotPipeline pipeline_for(const RobotProfile& profile, const std::string& slam);
/// An atlas of such pipelines. The profile outlives it.
pipeline::RobotAtlas atlas_for(const RobotProfile& profile, const std::string& slam);

}  // namespace echomap::apps
