// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/App.hpp>

#include "host/apps/command_action.hpp"

namespace echomap::apps {

/// Adds `echomap paper`.
void add_paper(CLI::App& app, CommandAction& action);

}  // namespace echomap::apps
