// SPDX-License-Identifier: MIT
#pragma once

#include "host/apps/commands.hpp"
#include "host/console/exit_code.hpp"

namespace echomap::apps {

/// Whether the log is a run directory that is replayed as the robot drove it: it holds the run's
/// observations and the robot's profile, and no option asks for another map. Where it is a run
/// directory that is not, says why.
bool is_replayed_as_driven(const ReplayOptions& options);

/// Plays the observations of a run, and those of its former maps, into pipelines like the run's
/// own. The run directory that it writes is the same, byte for byte, but for the report of the
/// replay in summary.json and what only the strategy knew (confidence_grid.csv). Throws
/// files::FileError and files::ConfigError.
console::ExitCode replay_run(const ReplayOptions& options);

}  // namespace echomap::apps
