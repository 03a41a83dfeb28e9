// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include <poll.h>

namespace echomap {
namespace boards {

/// Starts the clock at 0: the kernel's, or a simulated one behind a socket, of which every process
/// has a connection of its own (hil_mock/ev3 has the protocol).
void start_clock(const char* socket);
/// True for the simulated one, which stands still while this process does not sleep.
bool is_simulated();
/// Since the start.
uint64_t clock_us();
/// The simulated clock's own time at the start; 0 of the kernel's.
uint64_t started_at_us();

/// Sleeps until then, or until there is something of `waits`, or a signal.
void sleep_until(uint64_t until_us, pollfd* waits, nfds_t count);

}  // namespace boards
}  // namespace echomap
