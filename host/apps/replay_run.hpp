// SPDX-License-Identifier: MIT
#pragma once

#include "host/apps/commands.hpp"
#include "host/console/exit_code.hpp"

namespace echomap::apps {

/// Whether the log is a run directory whose observations are played: it holds them and the robot's
/// profile, and no option asks for a map that the robot's pipeline does not make. Where it is a run
/// directory that is not played, says why.
bool plays_observations(const ReplayOptions& options);

/// Plays the observations of a run, and those of its previous maps, into pipelines like the run's
/// own. The run directory that it writes is the same, byte for byte, but for the report of the
/// replay in summary.json and what only the strategy knew (confidence_grid.csv). Throws
/// files::FileError and files::ConfigError.
console::ExitCode replay_run(const ReplayOptions& options);

}  // namespace echomap::apps
