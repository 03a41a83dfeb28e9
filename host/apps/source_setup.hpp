// SPDX-License-Identifier: MIT
#pragma once

#include "host/session/robot_profile.hpp"
#include "host/source_search/source_readings.hpp"
#include "host/source_search/source_search.hpp"

namespace echomap::apps {

/// Throws CommandError 6 where the robot has no sensor that the search of a source understands.
void validate_searcher(const session::RobotProfile& profile);

/// How what the robot's sensor reads is placed and corrected.
source_search::SourceReadingsParams source_readings_params(const session::RobotProfile& profile);

/// How the robot searches a source in a room that it does not know yet.
source_search::SourceSearchParams source_search_params(const session::RobotProfile& profile);

}  // namespace echomap::apps
