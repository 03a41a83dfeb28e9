// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace boards {
namespace usb {

/// Bytes to send.
struct Bytes {
  const uint8_t* data;
  uint8_t size;
};

/// The descriptor of a type and index; none (size 0) where the device has no such. Strings: 0
/// languages, 1 maker, 2 product, 3 serial number.
Bytes descriptor(uint8_t type, uint8_t index);

}  // namespace usb
}  // namespace boards
}  // namespace echomap
