// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/App.hpp>

#include "host/apps/command_action.hpp"
#include "host/apps/commands.hpp"

namespace echomap::apps {

/// Each adds a sub-command that talks to a robot; where it is parsed, `action` becomes what it is
/// to do.
void add_explore(CLI::App& app, CommandAction& action);
void add_demo(CLI::App& app, CommandAction& action);
void add_flash(CLI::App& app, CommandAction& action);

/// The options of every command that speaks to a robot on a port.
void add_connection_options(CLI::App& command, session::ConnectionOptions& options);

/// The options of every command that drives a robot.
void add_run_options(CLI::App& command, RunOptions& run);

}  // namespace echomap::apps
