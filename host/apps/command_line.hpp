// SPDX-License-Identifier: MIT
#pragma once

#include "host/console/exit_code.hpp"

namespace echomap::apps {

/// The whole program: reads the arguments, runs the sub-command, turns every failure into a message
/// on stderr and an exit code.
console::ExitCode run_command_line(int argc, char** argv);

}  // namespace echomap::apps
