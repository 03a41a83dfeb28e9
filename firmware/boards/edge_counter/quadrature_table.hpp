// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/hal/flash_table.hpp"

namespace echomap {
namespace boards {

/// Both bits of a wheel changed at once: an edge was lost.
constexpr int8_t kIllegalStep = -2;

/// Step of one wheel (x4 decoding) from pin levels `before` to `after`, bit 0 A, bit 1 B: +1 in the
/// order 00 10 11 01 of A and B (A leads), -1 the other way, 0 for no change, or kIllegalStep.
constexpr int8_t quadrature_step(uint8_t before, uint8_t after) {
  const uint8_t changed = before ^ after;
  if (changed == 0) {
    return 0;
  }
  if (changed == 3) {
    return kIllegalStep;
  }
  const uint8_t before_a = before & 1U;
  const uint8_t after_b = (after >> 1) & 1U;
  return before_a == after_b ? 1 : -1;
}

/// What one change of the pins means, both wheels in one byte.
enum WheelEdges : uint8_t {
  kLeftForward = 1U << 0,
  kLeftBackward = 1U << 1,
  kLeftLost = 1U << 2,
  kRightForward = 1U << 3,
  kRightBackward = 1U << 4,
  kRightLost = 1U << 5,
};

/// The three bits of a wheel for its step, as they stand for the left one.
constexpr uint8_t left_edges(int8_t step) {
  if (step == kIllegalStep) {
    return kLeftLost;
  }
  if (step == 0) {
    return 0;
  }
  return step > 0 ? kLeftForward : kLeftBackward;
}

/// WheelEdges by `before << 4 | after`; levels have two bits per wheel, left wheel low.
struct QuadratureTable {
  uint8_t edges[256];

  constexpr QuadratureTable() : edges() {
    for (uint16_t i = 0; i < 256; ++i) {
      const uint8_t left = left_edges(quadrature_step((i >> 4) & 3U, i & 3U));
      const uint8_t right = left_edges(quadrature_step((i >> 6) & 3U, (i >> 2) & 3U));
      edges[i] = static_cast<uint8_t>(left | (right << 3));
    }
  }
};

/// The one table, in the program's memory.
constexpr QuadratureTable kQuadratureTable ECHOMAP_FLASH{};

}  // namespace boards
}  // namespace echomap
