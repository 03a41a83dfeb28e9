// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "host/pipeline/robot_localizer.hpp"

namespace echomap::tracking {

/// Why nothing is known of the robot after the whole log, for the user.
std::string why_nowhere(const pipeline::RobotLocalizer& localizer,
                        const std::filesystem::path& log,
                        const std::filesystem::path& map);

/// Why the robot is not followed from where it was said to start; empty where it is.
std::optional<std::string> trouble_of_start(localization::LocalizerOutcome start);

/// What has gone wrong although the robot was followed, a sentence each.
std::vector<std::string> troubles_of(const pipeline::RobotLocalizer& localizer);

}  // namespace echomap::tracking
