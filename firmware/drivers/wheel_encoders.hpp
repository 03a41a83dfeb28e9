// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace drivers {

/// Encoder counts of both wheels, modulo 2^16, forward positive.
struct WheelCounts {
  int16_t left;
  int16_t right;
};

/// The board's counts of two wheels, of which each may be wired the other way round.
class WheelEncoders {
 public:
  /// Which encoders count backwards; past counts stay as they are.
  void invert(bool left, bool right);

  WheelCounts counts() const;
  /// Of one wheel, a little sooner.
  int16_t left_count() const;
  int16_t right_count() const;

 private:
  /// Counts are an offset and the board's own, or without them.
  struct Wheel {
    int16_t offset;
    bool is_inverted;

    int16_t count(int16_t read) const;
    __attribute__((noinline)) void invert(bool inverted, int16_t read);
  };

  Wheel left_ = {0, false};
  Wheel right_ = {0, false};
};

}  // namespace drivers
}  // namespace echomap
