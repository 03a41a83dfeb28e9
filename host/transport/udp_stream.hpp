// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "host/transport/byte_stream.hpp"

namespace echomap::transport {

/// Listens on "udp://host:port", a number of this machine, for datagrams from anybody. Each is read
/// as a line: a line end is added where it has none, what does not fit into 4 KiB is cut off;
/// an empty one is passed over.
/// Nothing can be written. Throws TransportError where the port is taken or is not of this machine.
std::unique_ptr<ByteStream> open_udp_stream(const std::string& address);

}  // namespace echomap::transport
