// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/App.hpp>

#include "host/apps/command_action.hpp"

namespace echomap::apps {

/// Adds `echomap ports`.
void add_ports(CLI::App& app, CommandAction& action);

}  // namespace echomap::apps
