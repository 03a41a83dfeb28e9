// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/App.hpp>

#include "host/apps/command_action.hpp"

namespace echomap::apps {

/// Each adds a sub-command that talks to a robot; where it is parsed, `action` becomes what it is
/// to do.
void add_explore(CLI::App& app, CommandAction& action);
void add_demo(CLI::App& app, CommandAction& action);
void add_flash(CLI::App& app, CommandAction& action);

}  // namespace echomap::apps
