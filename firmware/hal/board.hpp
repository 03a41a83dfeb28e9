// SPDX-License-Identifier: MIT
#pragma once

namespace echomap {
namespace hal {

/// Brings pins, timers and the serial port into their first state, motors off; interrupts stay
/// locked. Every board calls the functions of events.hpp once they are unlocked.
void start_board();

}  // namespace hal
}  // namespace echomap
