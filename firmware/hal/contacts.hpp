// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace hal {

/// Bits of `pressed_contacts`.
enum Contact : uint8_t {
  kContactLeft = 1U << 0,
  kContactRight = 1U << 1,
};

/// The bump contacts that are closed now, not debounced.
uint8_t pressed_contacts();

}  // namespace hal
}  // namespace echomap
