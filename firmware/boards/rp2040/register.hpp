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

/// Sets bits of a register of the peripherals (not of the core or SIO), in one access.
inline void set_bits(Register& target, uint32_t bits) {
  block_at<Register>(reinterpret_cast<uint32_t>(&target) + 0x2000) = bits;
}

/// Clears bits of a register of the peripherals, in one access.
inline void clear_bits(Register& target, uint32_t bits) {
  block_at<Register>(reinterpret_cast<uint32_t>(&target) + 0x3000) = bits;
}

}  // namespace boards
}  // namespace echomap
