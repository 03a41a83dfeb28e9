// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/App.hpp>

#include "host/apps/command_action.hpp"

namespace echomap::apps {

/// Adds the sub-command that finds a robot, of a log or one that drives; where it is parsed,
/// `action` becomes what it is to do.
void add_localize(CLI::App& app, CommandAction& action);

}  // namespace echomap::apps
