// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/App.hpp>

#include "host/apps/command_action.hpp"

namespace echomap::apps {

/// The sub-command `search`; where it is parsed, `action` becomes what it is to do.
void add_search(CLI::App& app, CommandAction& action);

}  // namespace echomap::apps
