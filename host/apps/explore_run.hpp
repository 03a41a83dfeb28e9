// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "host/apps/explore_progress.hpp"
#include "host/apps/live_run.hpp"
#include "host/apps/resumed_run.hpp"
#include "host/apps/run_ending.hpp"
#include "host/exports/summary_json.hpp"
#include "host/session/robot_context.hpp"
#include "host/strategies/strategy_setup.hpp"

namespace echomap::apps {

/// How a robot explores, and where its run is written.
struct ExploreRun {
  const strategies::StrategyOptions& strategy;
  LiveRun& live;
  std::filesystem::path out;
  ProgressDisplay display = ProgressDisplay::kLine;
  bool align = true;              ///< Turn the pictures to the room's main direction.
  std::uint64_t split_bytes = 0;  ///< At which the recording goes on in another file; 0: never.
  NextCommands next{};
  std::optional<ResumedRun> resumed{};  ///< What the maps already know.
  /// Makes what drives the robot, for so much of the strategy as is left; null: the strategy alone.
  std::function<std::unique_ptr<exploration::Explorer>(const strategies::StrategyOptions& left)>
      make_explorer = nullptr;
  /// What is known of the room in all, where that is more than the robot's map; null: its map.
  std::function<pipeline::Snapshot()> known = nullptr;
  /// Shows more than the map on the live page; null for nothing.
  std::function<void(double time_s, live_page::RunPublisher& publisher)> show_more = nullptr;
};

/// The profile of the robot that is named. Throws files::ConfigError, and CommandError where the
/// strategy cannot do with it.
session::RobotProfile profile_for(const std::string& robot,
                                  const strategies::StrategyOptions& strategy);

/// Throws CommandError where a SLAM method is asked for that the robot has no ranges for.
void validate_slam(const RunOptions& run, const session::RobotProfile& profile);

/// Begins the maps of an exploration: the robot is placed by the camera whose fixes come to that
/// address or, where it is empty, by the SLAM method of that name. Throws CommandError 1 where the
/// camera cannot be listened to.
void begin_maps(session::RobotContext& robot, const std::string& fixes, const std::string& slam);

/// Opens the port of a robot that explores; describes a simulated one in `summary`. Throws as
/// session::open_robot does.
void open_port(session::RobotContext& robot,
               const session::ConnectionOptions& connection,
               const strategies::StrategyOptions& strategy,
               exports::RunSummary& summary);

/// Connects and lets the strategy drive the robot until it is finished, is interrupted or is lost.
/// The run directory is brought up to date after every stop, so that whatever happens the map so
/// far is on disk. Fills in what the exploration knows of `summary`. Throws CommandError where no
/// robot is found and files::FileError where the map cannot be saved.
RunEnding explore_and_save(session::RobotContext& robot,
                           const ExploreRun& run,
                           exports::RunSummary& summary);

}  // namespace echomap::apps
