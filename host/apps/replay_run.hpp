// SPDX-License-Identifier: MIT
#pragma once

#include "host/apps/commands.hpp"
#include "host/console/exit_code.hpp"

namespace echomap::apps {

/// Whether the log is the recording of a run that is played: no option asks for a map that the
/// robot's pipeline does not make. Where it is a recording that is not played, says why.
bool plays_recording(const ReplayOptions& options);

/// Plays the recording of a run into pipelines like the run's own. The run directory that it writes
/// is the same, byte for byte, but for the report of the replay in summary.json and what only the
/// strategy knew (confidence_grid.csv). Throws files::FileError and files::ConfigError.
console::ExitCode replay_run(const ReplayOptions& options);

}  // namespace echomap::apps
