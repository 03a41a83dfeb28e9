// SPDX-License-Identifier: MIT
#pragma once

namespace echomap::transport {

/// Sets the speed of an open serial line, any number of bits per second that its driver takes.
/// Modem lines, settings and bytes on their way stay; false where the driver takes no such speed.
bool set_line_speed(int fd, int baud);

}  // namespace echomap::transport
