// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "host/boards/boards.hpp"
#include "host/console/shell_line.hpp"
#include "host/transport/port_list.hpp"
#include "host/transport/usb_devices.hpp"

namespace echomap::flashing {

/// What hangs on this machine.
struct AttachedDevices {
  std::vector<transport::PortInfo> ports;
  std::vector<transport::UsbDevice> usb;  ///< With or without a port.
};

/// What the user said.
struct FlashRequest {
  std::string board{};  ///< Empty where it follows from the port.
  std::string port{};  ///< A path, or id:TEXT for a part of serial number or description; or empty.
};

/// What will be run.
struct FlashPlan {
  std::string place;                         ///< Port and what hangs there, in words.
  std::vector<console::CommandWords> tries;  ///< One after the other, until one succeeds.
  std::string package;                       ///< The Debian package that holds the program.
  std::string advice;                        ///< What to look at where all fail.
};

/// A board and the place to write to.
struct FlashTarget {
  const boards::Board* board = nullptr;
  std::string port;    ///< Path; empty for an ST-Link.
  std::string serial;  ///< Of the ST-Link, where there are several.
  std::string what;    ///< In words, with the USB id.
};

/// Which board hangs where. Without a port named, only a USB id that is one board's alone is taken,
/// and only where one such board is here. The id of a serial chip that many things use needs both
/// port and board said; an ST-Link needs the board said, and the port where there are several.
/// Throws CommandError 3 with what is here and what to do for all else: a port without a USB id, an
/// id that is no board's, another board than the one said.
FlashTarget choose_flash_target(const FlashRequest& request, const AttachedDevices& attached);

/// The commands that write `image` there.
FlashPlan flash_plan(const FlashTarget& target, const std::string& image);

}  // namespace echomap::flashing
