// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/transport/usb_id.hpp"

namespace echomap::transport {

/// A serial port of this machine.
struct PortInfo {
  std::string name;                            ///< Path, for example /dev/ttyACM0.
  std::string description;                     ///< As the device tells it; may be empty.
  std::string serial_number;                   ///< Of the USB device; may be empty.
  std::optional<UsbId> usb_id = std::nullopt;  ///< Absent where it hangs on no USB.
};

/// USB and Bluetooth serial ports, by libserialport. A PC's own ports (/dev/ttyS0) are left out:
/// they are listed on machines that have none, and no robot hangs on them.
std::vector<PortInfo> list_ports();

/// The TEXT of a port named "id:TEXT"; empty for every other name.
std::optional<std::string_view> port_id_text(std::string_view name);

/// The ports whose serial number or description holds `text`.
std::vector<PortInfo> ports_with_id(const std::vector<PortInfo>& ports, std::string_view text);

/// The ports in words for an error: "ports here: /dev/ttyACM0 (Arduino Uno)" or that there are
/// none.
std::string describe_ports(const std::vector<PortInfo>& ports);

}  // namespace echomap::transport
