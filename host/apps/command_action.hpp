// SPDX-License-Identifier: MIT
#pragma once

#include <functional>

#include "host/console/exit_code.hpp"

namespace echomap::apps {

/// What a sub-command does once its arguments are understood; empty where there is none.
using CommandAction = std::function<console::ExitCode()>;

}  // namespace echomap::apps
