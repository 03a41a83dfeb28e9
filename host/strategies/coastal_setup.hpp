// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "host/exploration/coastal.hpp"
#include "host/session/robot_profile.hpp"

namespace echomap::strategies {

/// What the profile has not and the strategy needs for that hand, in words; empty where nothing
/// lacks.
std::string lack_for_coastal(const session::RobotProfile& profile, exploration::Hand hand);

/// For a profile that lacks nothing.
exploration::CoastalParams coastal_params(const session::RobotProfile& profile,
                                          exploration::Hand hand);

/// The same nearer to Mukherjee et al., section IV: it ends when the angle about the start
/// is a full turn, and bears away from a wall only at a bump.
exploration::CoastalParams as_told(exploration::CoastalParams params);

}  // namespace echomap::strategies
