// SPDX-License-Identifier: MIT
#pragma once

namespace echomap::transport {

/// Asks the driver of the serial device `fd` to hand bytes on at once (ASYNC_LOW_LATENCY): an FTDI
/// chip then waits 1 ms for more of them instead of 16. True where this has changed the device;
/// false where it was so before, or where its driver knows no such thing (CH340, CP210x, CDC).
bool lower_latency(int fd);

/// Takes `lower_latency` back.
void restore_latency(int fd);

}  // namespace echomap::transport
