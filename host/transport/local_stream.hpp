// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "host/transport/byte_stream.hpp"

namespace echomap::transport {

/// Connects to the Unix-domain socket at `path`. Throws TransportError.
std::unique_ptr<ByteStream> open_local_stream(const std::string& path);

}  // namespace echomap::transport
