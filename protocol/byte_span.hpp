// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace protocol {

/// A borrowed run of bytes that is only read; the owner keeps it alive.
struct ByteSpan {
  const uint8_t* data;
  uint8_t size;
};

}  // namespace protocol
}  // namespace echomap
