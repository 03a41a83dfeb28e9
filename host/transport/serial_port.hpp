// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "host/transport/byte_stream.hpp"

namespace echomap::transport {

/// Opens a serial device for this process alone (`open_port_alone`, `exclude_others`) at any `baud`
/// its driver takes, 8N1, no flow control, with low latency where its driver knows it. Neither
/// opening nor closing lowers DTR (HUPCL is off), so that an Arduino which runs with DTR up goes
/// on. Where DTR is down, as after plugging in, the kernel raises it within open(2): that resets
/// the board and nothing can keep it from it. Throws TransportError.
std::unique_ptr<ByteStream> open_serial_port(const std::string& path, int baud);

}  // namespace echomap::transport
