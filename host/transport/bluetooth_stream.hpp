// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "host/transport/byte_stream.hpp"

namespace echomap::transport {

/// Connects to the serial port profile of "bt://ADDRESS" or "bt://ADDRESS/CHANNEL" within ten
/// seconds, without an rfcomm device. The module has to be paired. Throws TransportError.
std::unique_ptr<ByteStream> open_bluetooth_stream(const std::string& address);

}  // namespace echomap::transport
