// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "host/apps/commands.hpp"
#include "host/apps/driven_robot.hpp"
#include "host/console/exit_code.hpp"
#include "host/exports/summary_json.hpp"
#include "host/session/robot_profile.hpp"

namespace echomap::apps {

/// The profile of the robot that is named. Throws files::ConfigError, and CommandError where the
/// strategy cannot do with it.
session::RobotProfile profile_for(const RunOptions& options);

/// Connects and lets the strategy drive the robot until it is finished, is interrupted or is lost.
/// The run directory `out` is brought up to date after every stop, so that whatever happens the map
/// so far is on disk. Fills in what the exploration knows of `summary`. Throws CommandError where
/// no robot is found and files::FileError where the map cannot be saved.
ExitCode explore_and_save(const DrivenRobot& robot,
                          const RunOptions& options,
                          const std::filesystem::path& out,
                          exports::RunSummary& summary);

}  // namespace echomap::apps
