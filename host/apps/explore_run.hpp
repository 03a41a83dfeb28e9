// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>

#include "host/apps/commands.hpp"
#include "host/apps/exit_code.hpp"
#include "host/apps/robot_connection.hpp"
#include "host/apps/robot_profile.hpp"
#include "host/exports/summary_json.hpp"

namespace echomap::apps {

/// A session's number from any other: never 0, which a robot that has just started stands for.
std::uint16_t session_id_from(std::uint32_t number);

/// The profile of the robot that is named. Throws files::ConfigError, and CommandError where the
/// strategy cannot do with it.
RobotProfile profile_for(const RunOptions& options);

/// Connects and lets the strategy drive the robot until it is finished, is interrupted or is lost.
/// The run directory `out` is brought up to date after every stop, so that whatever happens the map
/// so far is on disk. Fills in what the exploration knows of `summary`. Throws CommandError where
/// no robot is found and files::FileError where the map cannot be saved.
ExitCode explore_and_save(RobotConnection robot,
                          const RobotProfile& profile,
                          const RunOptions& options,
                          const std::filesystem::path& out,
                          exports::RunSummary& summary);

}  // namespace echomap::apps
