// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/App.hpp>

#include "host/apps/command_action.hpp"
#include "host/apps/commands.hpp"

namespace echomap::apps {

/// `--listen` and `--no-browser`; where the page `is_asked_for`, `--live`, too, without which
/// nothing is served.
void add_live_options(CLI::App& command, LiveOptions& options, bool is_asked_for);

/// `--speed`: times real time; "max" is 0, as fast as it can.
CLI::Option* add_speed_option(CLI::App& command, double& factor);

/// The sub-command `serve`.
void add_serve(CLI::App& app, CommandAction& action);

}  // namespace echomap::apps
