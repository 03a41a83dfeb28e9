// SPDX-License-Identifier: MIT
#include "host/transport/open_stream.hpp"

#include <filesystem>

#include "host/transport/bluetooth_address.hpp"
#include "host/transport/bluetooth_stream.hpp"
#include "host/transport/pty_port.hpp"
#include "host/transport/serial_port.hpp"
#include "host/transport/tcp_address.hpp"
#include "host/transport/tcp_stream.hpp"

namespace echomap::transport {

PortKind port_kind(const std::string& port) {
  if (is_tcp_address(port)) {
    return PortKind::kTcp;
  }
  if (is_bluetooth_address(port)) {
    return PortKind::kBluetooth;
  }
  std::error_code ignored;
  const auto real = std::filesystem::weakly_canonical(port, ignored);
  return real.parent_path() == "/dev/pts" ? PortKind::kPty : PortKind::kSerial;
}

bool is_radio(const std::string& port) {
  std::error_code ignored;
  const auto device = std::filesystem::weakly_canonical(port, ignored).string();
  return is_bluetooth_address(port) || device.starts_with("/dev/rfcomm");
}

std::unique_ptr<ByteStream> open_stream(const std::string& port, int baud) {
  switch (port_kind(port)) {
    case PortKind::kTcp:
      return open_tcp_stream(port);
    case PortKind::kBluetooth:
      return open_bluetooth_stream(port);
    case PortKind::kPty:
      return open_pty_port(port);
    case PortKind::kSerial:
      break;
  }
  return open_serial_port(port, baud);
}

}  // namespace echomap::transport
