// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstdint>
#include <string>

namespace echomap::transport {

/// Who made a USB device and which of theirs it is, as the device itself says.
struct UsbId {
  std::uint16_t vendor = 0;
  std::uint16_t product = 0;
  auto operator<=>(const UsbId&) const = default;
};

/// As lsusb writes it: "2341:0043".
std::string to_string(UsbId id);

}  // namespace echomap::transport
