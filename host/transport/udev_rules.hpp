// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace echomap::transport {

/// The name of the rules' file. Rules are read in the order of the names: these come before
/// 77-mm-* and 80-mm-candidate.rules, where ModemManager chooses, and before 73-seat-late.rules,
/// which gives devices with the tag uaccess to the person at the machine.
inline constexpr const char* kUdevRulesName = "60-echomap.rules";

/// Rules of udev(7) for the serial ports of `known_usb_ids`: ModemManager leaves them alone, the
/// group dialout and the person at the machine may open them, and each has a name that stays the
/// same for its socket, /dev/echomap-1-1.2.
std::string udev_rules();

}  // namespace echomap::transport
