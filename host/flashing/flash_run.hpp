// SPDX-License-Identifier: MIT
#pragma once

#include "host/console/exit_code.hpp"
#include "host/flashing/flash_plan.hpp"

namespace echomap::flashing {

/// Prints each command on stdout before it runs it, with the terminal to itself, until one
/// succeeds; only prints them all where `dry_run`. Throws CommandError 1 where the program is
/// missing or every try fails. Ctrl-C ends it with kInterrupted.
console::ExitCode carry_out(const FlashPlan& plan, bool dry_run);

}  // namespace echomap::flashing
