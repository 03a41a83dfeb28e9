// SPDX-License-Identifier: MIT
#pragma once

#include "host/apps/commands.hpp"
#include "host/console/shell_line.hpp"

namespace echomap::apps {

/// The options that decide how a robot explores, where they are not as by default: the strategy
/// with what it goes by, and the SLAM method. Without --stops, which cut the run short.
console::CommandWords strategy_words(const RunOptions& run);

/// `--robot NAME` where it is not the usual one.
console::CommandWords robot_words(const RunOptions& run);

}  // namespace echomap::apps
