// SPDX-License-Identifier: MIT
#pragma once

namespace echomap::live_page {

/// The server's clock, milliseconds: steady, the same in the whole program. Motions carry it, and
/// commands that steer give it back.
double server_clock_ms();

}  // namespace echomap::live_page
