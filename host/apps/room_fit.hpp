// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "host/apps/run_ending.hpp"
#include "host/evaluation/truth_directory.hpp"

namespace echomap::apps {

/// Share of the floor around its start that a robot of that radius can get over, of what one as
/// small as a cell could.
double share_in_reach(const evaluation::Truth& truth, double robot_radius_m);

/// The same ending, but unfinished where a robot has finished that cannot get over most of its
/// simulated room. For a robot without a measure of what it has seen (`coverage_of`), which takes
/// what holds it in for the room; `next` is the command for a larger one.
RunEnding with_narrow_room(RunEnding ending,
                           const evaluation::Truth& truth,
                           const session::RobotProfile& profile,
                           const std::string& next);

}  // namespace echomap::apps
