// SPDX-License-Identifier: MIT
#pragma once

namespace echomap {
namespace hal {

/// There are bytes to send: the port asks `next_byte_to_send` until it answers false.
void request_send();

}  // namespace hal
}  // namespace echomap
