// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace differential {

/// Marsaglia's xorshift (Journal of Statistical Software 8(14), 2003), of 32 bits on every chip.
class Random {
 public:
  /// The sequence of `seed`; two seeds share none of their first numbers.
  constexpr explicit Random(uint32_t seed) : state_(seed * uint32_t{2654435769U} + 1013904223U) {}

  uint32_t next() {
    if (state_ == 0) {
      state_ = 1;
    }
    state_ ^= state_ << 13;
    state_ ^= state_ >> 17;
    state_ ^= state_ << 5;
    return state_;
  }
  uint16_t bits16() { return static_cast<uint16_t>(next() >> 16); }
  uint8_t bits8() { return static_cast<uint8_t>(next() >> 24); }
  /// True once in 2 to the power of `log2` times, 0 .. 15.
  bool once_in(uint8_t log2) { return (bits16() & ((uint32_t{1} << log2) - 1)) == 0; }
  /// 0 .. limit - 1; 0 for a limit of 0.
  uint16_t below(uint16_t limit) {
    return static_cast<uint16_t>((uint32_t{bits16()} * limit) >> 16);
  }
  /// Of every size, with the numbers at which 15, 16 and the firmware's limits end among them.
  uint16_t wide() {
    constexpr uint16_t kEdges[16] = {0,
                                     1,
                                     2,
                                     125,
                                     4500,
                                     31999,
                                     32000,
                                     32001,
                                     32750,
                                     32751,
                                     32752,
                                     32767,
                                     32768,
                                     32769,
                                     65534,
                                     65535};
    const uint32_t drawn = next();
    const uint8_t choice = static_cast<uint8_t>(drawn >> 8) & 15U;
    return (drawn & 3U) == 0 ? kEdges[choice] : static_cast<uint16_t>((drawn >> 16) >> choice);
  }

 private:
  uint32_t state_;
};

}  // namespace differential
}  // namespace echomap
