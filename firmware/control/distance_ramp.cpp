// SPDX-License-Identifier: MIT
#include "firmware/control/distance_ramp.hpp"

namespace echomap {
namespace control {

void DistanceRamp::start(int32_t distance, int32_t cruise, int32_t change) {
  remaining_ = distance;
  cruise_ = cruise;
  change_ = change < cruise ? change : cruise;
  speed_ = 0;
  braking_ = 0;
}

int32_t DistanceRamp::advance() {
  const int32_t faster = speed_ + change_;
  const bool may_speed_up = faster <= cruise_ && faster + speed_ + braking_ <= remaining_;
  if (speed_ == 0 || may_speed_up) {
    speed_up();
  } else if (speed_ > change_ && speed_ + braking_ > remaining_) {
    slow_down();
  }
  const int32_t step = speed_ < remaining_ ? speed_ : remaining_;
  remaining_ -= step;
  return step;
}

void DistanceRamp::brake(int32_t change) {
  change_ = change;
  braking_ = 0;
  for (int32_t speed = speed_ - change; speed > 0; speed -= change) {
    braking_ += speed;
  }
  if (braking_ < remaining_) {
    remaining_ = braking_;
  }
}

void DistanceRamp::speed_up() {
  braking_ += speed_;
  speed_ += change_;
}

void DistanceRamp::slow_down() {
  speed_ -= change_;
  braking_ -= speed_;
}

}  // namespace control
}  // namespace echomap
