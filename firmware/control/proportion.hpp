// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace control {

/// Scales steps of a longer way to steps of a shorter one and carries the remainders along: over
/// any move the sum is right to a tenth of a tick. The ratio is two digits of 12 bits, so that
/// nothing needs 64.
class Proportion {
 public:
  /// `part` of `whole` ticks; 0 <= part <= whole <= protocol::kMaxMoveTicks, whole above 0.
  void start(int32_t part, int32_t whole);
  /// The shorter way's step for the longer way's `step`, 0 .. 2^19.
  int32_t scale(int32_t step);

 private:
  uint16_t high_digit_ = 0;
  uint16_t low_digit_ = 0;
  uint16_t carried_ = 0;
};

}  // namespace control
}  // namespace echomap
