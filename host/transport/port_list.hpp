// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
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
  std::optional<UsbId> usb_id = std::nullopt;  ///< Absent where it is not on the USB.
  /// Socket and interface, as sysfs names them: "1-1.2:1.0"; empty where it is not on the USB.
  std::string usb_path = {};
};

/// USB and Bluetooth serial ports in the order of their names, as Linux shows them below `sysfs`
/// (Documentation/ABI/stable/sysfs-bus-usb). A PC's own ports (/dev/ttyS0) are left out: they are
/// listed on machines that have none, and no robot is there. Opens none of them.
std::vector<PortInfo> list_ports(const std::filesystem::path& sysfs = "/sys");

/// Whether both are one device, whatever name its port has: of one USB id, with one serial number,
/// or in one socket where it has none of its own; without a USB it is known by its name alone.
bool is_same_device(const PortInfo& one, const PortInfo& other);

/// The TEXT of a port named "id:TEXT"; empty for every other name.
std::optional<std::string_view> port_id_text(std::string_view name);

/// The ports whose serial number or description holds `text`.
std::vector<PortInfo> ports_with_id(const std::vector<PortInfo>& ports, std::string_view text);

/// The ports in words for an error: "ports here: /dev/ttyACM0 (Arduino Uno)" or that there are
/// none.
std::string describe_ports(const std::vector<PortInfo>& ports);

}  // namespace echomap::transport
