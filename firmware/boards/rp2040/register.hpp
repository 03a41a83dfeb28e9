// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/boards/cortex_common/register.hpp"

namespace echomap {
namespace boards {

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
