// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace protocol {

/// Another major: frames of the two sides cannot be understood. The minor goes up whenever the
/// messages change, so that a mismatch can name the older side.
constexpr uint8_t kProtocolMajor = 1;
constexpr uint8_t kProtocolMinor = 1;

/// Version of the firmware in hundredths: 11 is 0.1.1.
constexpr uint16_t kFirmwareVersion = 11;

}  // namespace protocol
}  // namespace echomap
