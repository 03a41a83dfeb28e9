// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace boards {

/// A register: every access is one of 32 bits, in the order written.
using Register = volatile uint32_t;

/// The block of registers at a fixed address.
template <class Block>
inline Block& block_at(uint32_t address) {
  return *reinterpret_cast<Block*>(address);
}

/// The word with this one bit set.
constexpr uint32_t bit(uint8_t number) { return uint32_t{1} << number; }

}  // namespace boards
}  // namespace echomap
