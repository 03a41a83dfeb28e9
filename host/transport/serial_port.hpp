// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "host/transport/byte_stream.hpp"

namespace echomap::transport {

/// Opens a serial device at any `baud` its driver takes, 8N1, no flow control. Closing does not
/// drop DTR (HUPCL is off), so that the next opening does not reset an Arduino. Throws
/// TransportError.
std::unique_ptr<ByteStream> open_serial_port(const std::string& path, int baud);

}  // namespace echomap::transport
