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

/// The bump contacts that are closed now, not debounced.
uint8_t closed_contacts();

}  // namespace hal
}  // namespace echomap
