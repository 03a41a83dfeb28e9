// SPDX-License-Identifier: MIT
#pragma once

namespace echomap {
namespace hal {

/// Starts the watchdog: 125 ms without `kick_watchdog` switch the motors off, 250 ms reset.
void start_watchdog();
void kick_watchdog();

}  // namespace hal
}  // namespace echomap
