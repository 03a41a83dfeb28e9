// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace hal {

/// There are bytes to send: the port asks `next_byte_to_send` until it answers false.
void request_send();

/// Bytes that the line sends in a second: its bit rate by ten. One of more than 65,535 says 65,535.
uint16_t line_bytes_per_s();

}  // namespace hal
}  // namespace echomap
