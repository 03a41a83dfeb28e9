// SPDX-License-Identifier: MIT
#include "firmware/tasks/safety.hpp"

namespace echomap {
namespace tasks {

using protocol::MotionOutcome;

void Safety::disarm() {
  armed_ = false;
  motion_.stop(MotionOutcome::kStopped);
}

void Safety::renew(uint16_t time_to_live_ms) {
  left_to_live_ms_ = time_to_live_ms == 0 ? protocol::kDefaultTimeToLiveMs : time_to_live_ms;
}

void Safety::tick() {
  contacts_.poll();
  if (motion_.moving() && bumped()) {
    motion_.stop(MotionOutcome::kBumped);
  }
  if (left_to_live_ms_ != 0 && --left_to_live_ms_ == 0) {
    motion_.expire();
  }
}

bool Safety::bumped() const {
  return (contacts_.any() && motion_.goes_forward()) ||
         (contacts_.just_pressed() && !motion_.only_backs_off());
}

}  // namespace tasks
}  // namespace echomap
