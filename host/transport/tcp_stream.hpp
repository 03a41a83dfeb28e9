// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "host/transport/byte_stream.hpp"

namespace echomap::transport {

/// Connects to "tcp://host:port" ("tcp://[::1]:port" for IPv6) within five seconds, and five more
/// to look the name up, without Nagle's delay. A peer that is gone without a word closes the stream
/// after two seconds. Throws TransportError.
std::unique_ptr<ByteStream> open_tcp_stream(const std::string& address);

}  // namespace echomap::transport
