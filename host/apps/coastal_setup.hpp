// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "host/apps/robot_profile.hpp"
#include "host/exploration/coastal.hpp"

namespace echomap::apps {

/// What the profile has not and the strategy needs for that hand, in words; empty where nothing
/// lacks.
std::string lack_for_coastal(const RobotProfile& profile, exploration::Hand hand);

/// For a profile that lacks nothing.
exploration::CoastalParams coastal_params(const RobotProfile& profile, exploration::Hand hand);

}  // namespace echomap::apps
