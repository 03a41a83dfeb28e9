// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "host/transport/byte_stream.hpp"

namespace echomap::transport {

/// Opens the slave side of a pseudo terminal, raw, for this process alone (`open_port_alone`), and
/// drops what was sent before. A pty has no
/// baud rate and no modem lines, which is why libserialport refuses it. Throws TransportError.
std::unique_ptr<ByteStream> open_pty_port(const std::string& path);

}  // namespace echomap::transport
