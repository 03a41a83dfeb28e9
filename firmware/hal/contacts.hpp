// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace hal {

/// Bits of `closed_contacts`.
enum Contact : uint8_t {
  kContactLeft = 1U << 0,
  kContactRight = 1U << 1,
};

/// Bits of the contacts that are closed.
constexpr uint8_t contact_bits(bool left_is_closed, bool right_is_closed) {
  return static_cast<uint8_t>((left_is_closed ? kContactLeft : 0) |
                              (right_is_closed ? kContactRight : 0));
}

/// The bump contacts that are closed now, not debounced.
uint8_t closed_contacts();

}  // namespace hal
}  // namespace echomap
