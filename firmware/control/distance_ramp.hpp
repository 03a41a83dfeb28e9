// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace control {

/// A distance covered with a trapezoid of speed: up by `change` per period, cruise, and down so as
/// to end exactly there. It keeps the distance that braking will take as a running sum, which needs
/// neither a division nor a root. Units of fixed_point.hpp, nothing negative.
class DistanceRamp {
 public:
  /// Both speeds are above 0. It cruises at the greatest multiple of `change` within `cruise`; a
  /// greater `change` counts as `cruise`.
  void start(int32_t distance, int32_t cruise, int32_t change);

  /// Distance of the next period; 0 when there.
  int32_t advance();
  bool finished() const { return remaining_ == 0; }

  /// Brakes from now on by `change` per period, above 0, and ends where that leads.
  void brake(int32_t change);

 private:
  void speed_up();
  void slow_down();

  int32_t remaining_ = 0;
  int32_t speed_ = 0;
  int32_t cruise_ = 0;
  int32_t change_ = 0;
  int32_t braking_ = 0;  ///< Sum of speed - change, speed - 2 change, .. above 0.
};

}  // namespace control
}  // namespace echomap
