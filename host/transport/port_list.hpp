// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace echomap::transport {

/// A serial port of this machine.
struct PortInfo {
  std::string name;           ///< Path, for example /dev/ttyACM0.
  std::string description;    ///< As the device tells it; may be empty.
  std::string serial_number;  ///< Of the USB device; may be empty.
};

/// USB and Bluetooth serial ports, by libserialport. A PC's own ports (/dev/ttyS0) are left out:
/// they are listed on machines that have none, and no robot hangs on them.
std::vector<PortInfo> list_ports();

/// The ports in words for an error: "ports here: /dev/ttyACM0 (Arduino Uno)" or that there are
/// none.
std::string describe_ports(const std::vector<PortInfo>& ports);

}  // namespace echomap::transport
