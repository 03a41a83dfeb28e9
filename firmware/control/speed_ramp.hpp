// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace control {

/// A speed that follows its target no faster than an acceleration allows. Units of fixed_point.hpp.
class SpeedRamp {
 public:
  /// Starts at `speed`; `change` is the most that it changes per period, above 0.
  void start(int32_t speed, int32_t change);
  void set_target(int32_t target) { target_ = target; }
  /// Goes to rest from now on by `change` per period, above 0.
  void brake(int32_t change);

  /// The speed of the next period.
  int32_t advance();
  bool at_rest() const { return (speed_ | target_) == 0; }

 private:
  int32_t speed_ = 0;
  int32_t target_ = 0;
  int32_t change_ = 1;
};

}  // namespace control
}  // namespace echomap
