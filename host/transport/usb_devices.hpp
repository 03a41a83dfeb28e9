// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "host/transport/usb_id.hpp"

namespace echomap::transport {

/// A device on the USB, with or without a serial port.
struct UsbDevice {
  UsbId id;
  std::string description;    ///< As the device tells it; may be empty.
  std::string serial_number;  ///< May be empty.
};

/// The USB device in this folder of sysfs; empty where it is none.
std::optional<UsbDevice> usb_device_at(const std::filesystem::path& folder);

/// The USB devices of this machine in the order of their names, as Linux shows them below `folder`
/// (Documentation/ABI/stable/sysfs-bus-usb); none where there is no such folder.
std::vector<UsbDevice> list_usb_devices(
    const std::filesystem::path& folder = "/sys/bus/usb/devices");

}  // namespace echomap::transport
