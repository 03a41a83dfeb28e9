// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include <CLI/App.hpp>

#include "host/apps/command_action.hpp"

namespace echomap::apps {

/// Each adds a sub-command that works on maps and logs; where it is parsed, `action` becomes what
/// it is to do.
void add_eval(CLI::App& app, CommandAction& action);
void add_diff(CLI::App& app, CommandAction& action);
void add_characterise(CLI::App& app, CommandAction& action);
void add_replay(CLI::App& app, CommandAction& action);
void add_export(CLI::App& app, CommandAction& action);

/// The file of a log, which is answered, and its format.
CLI::Option* add_log_options(CLI::App& command, std::filesystem::path& log, std::string& format);

/// Where a run is written, and whether in the place of one that is there.
void add_out_options(CLI::App& command, std::filesystem::path& out, bool& force);

/// Whether the pictures that a command writes are turned to the room's main direction.
void add_align_option(CLI::App& command, bool& align);

}  // namespace echomap::apps
