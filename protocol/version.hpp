// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace protocol {

/// Major: frames of the two sides cannot be understood. Minor: messages were added.
constexpr uint8_t kProtocolMajor = 1;
constexpr uint8_t kProtocolMinor = 0;

/// Version of the firmware in hundredths: 10 is 0.1.
constexpr uint16_t kFirmwareVersion = 10;

}  // namespace protocol
}  // namespace echomap
