// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace drivers {

/// Both bits of a wheel changed at once: an edge was lost.
constexpr int8_t kIllegalStep = -128;

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

/// Steps of both wheels by `before << 4 | after`, two bits per wheel, left wheel low.
struct QuadratureTable {
  int8_t left[256];
  int8_t right[256];

  constexpr QuadratureTable() : left(), right() {
    for (uint16_t i = 0; i < 256; ++i) {
      left[i] = quadrature_step((i >> 4) & 3U, i & 3U);
      right[i] = quadrature_step((i >> 6) & 3U, (i >> 2) & 3U);
    }
  }
};

}  // namespace drivers
}  // namespace echomap
