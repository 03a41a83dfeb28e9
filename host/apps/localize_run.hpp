// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include <nlohmann/json_fwd.hpp>

#include "host/apps/commands.hpp"
#include "host/pipeline/robot_localizer.hpp"
#include "host/session/robot_context.hpp"
#include "host/tracking/live_filter.hpp"
#include "host/tracking/localization_drive.hpp"

namespace echomap::apps {

/// A robot that drives from stop to stop, and the filter that listens.
struct FollowedRobot {
  session::RobotContext& context;
  tracking::LocalizationDrive& driver;
  tracking::LiveFilter& filter;
};

/// How that robot is localized. Throws CommandError where the preset does not fit it.
pipeline::RobotLocalizerParams localizer_params(const session::RobotProfile& profile,
                                                const LocalizeOptions& options);
/// What of the options every filter has, whatever the robot.
void set_filter(const LocalizeOptions& options, pipeline::RobotLocalizerParams& params);

/// Drives to the next stop, records and says where the robot is. Once it is not where it was
/// thought to be, the driver's own map is void, too. False where the drive is over.
bool follow_to_next_stop(const FollowedRobot& robot);

/// `echomap localize` of a robot on a port: drives it from stop to stop and writes trajectory.tum
/// and summary.json into `out`, whatever ends it. Throws CommandError and files::FileError.
ExitCode localize_robot(const LocalizeOptions& options, const std::filesystem::path& out);

}  // namespace echomap::apps
