// SPDX-License-Identifier: MIT
#pragma once

namespace echomap {
namespace hal {

/// Starts the watchdog: 57 to 125 ms without `kick_watchdog`, by board, switch the motors off and
/// start the program again, at once or after as long a time; with interrupts locked a reset does.
void start_watchdog();
void kick_watchdog();

}  // namespace hal
}  // namespace echomap
