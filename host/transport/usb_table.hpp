// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "host/transport/usb_id.hpp"

namespace echomap::transport {

/// What is at the USB, by its id.
enum class UsbRole : std::uint8_t {
  kBoard,       ///< One kind of board and nothing else.
  kSerialChip,  ///< A serial chip of boards, and of printers, modems and meters too.
  kOwnUsb,      ///< A chip whose program is the serial port, whatever else it does.
  kProgrammer,  ///< An ST-Link.
  kBootDrive,   ///< A chip that waits for its program: a drive, not a serial port.
};

/// A USB id of boards that robots are made of.
struct KnownUsbId {
  UsbId id;
  UsbRole role = UsbRole::kSerialChip;
  std::string_view what;
  std::string_view board;  ///< Name of the only board with this id; empty for the other roles.
};

/// Every id that a robot's board may have.
std::span<const KnownUsbId> known_usb_ids();

/// What is known of an id; null for what is no board's.
const KnownUsbId* known_usb_id(UsbId id);

/// Whether a robot may be behind a serial port with this id. No id proves that one is: a CH340 is
/// in 3D printers, too.
bool may_be_robot(UsbId id);

}  // namespace echomap::transport
