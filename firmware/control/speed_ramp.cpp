// SPDX-License-Identifier: MIT
#include "firmware/control/speed_ramp.hpp"

namespace echomap {
namespace control {

void SpeedRamp::start(int32_t speed, int32_t change) {
  speed_ = speed;
  target_ = speed;
  change_ = change;
}

void SpeedRamp::brake(int32_t change) {
  target_ = 0;
  change_ = change;
}

int32_t SpeedRamp::advance() {
  const int32_t missing = target_ - speed_;
  if (missing > change_) {
    speed_ += change_;
  } else if (missing < -change_) {
    speed_ -= change_;
  } else {
    speed_ = target_;
  }
  return speed_;
}

}  // namespace control
}  // namespace echomap
