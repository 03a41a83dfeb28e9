// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include "host/transport/byte_stream.hpp"

namespace echomap::transport {

/// What carries the bytes of a port, judged by its name alone.
enum class PortKind : std::uint8_t {
  kTcp,        ///< "tcp://host:port".
  kBluetooth,  ///< "bt://00:11:22:33:44:55".
  kPty,        ///< A path, or a link to one, under /dev/pts.
  kSerial,     ///< Any other path.
};
PortKind port_kind(const std::string& port);

/// Whether a Bluetooth radio carries the bytes: an address, or an rfcomm device.
bool is_radio(const std::string& port);

/// Opens `port`; `baud` (bits per second) counts for serial ports only.
/// Throws TransportError; where no such port exists it names those that do.
std::unique_ptr<ByteStream> open_stream(const std::string& port, int baud);

}  // namespace echomap::transport
