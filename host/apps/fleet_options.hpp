// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/App.hpp>

#include "host/apps/command_action.hpp"

namespace echomap::apps {

/// Adds `echomap fleet` and the sub-commands of several robots below it.
void add_fleet(CLI::App& app, CommandAction& action);

}  // namespace echomap::apps
