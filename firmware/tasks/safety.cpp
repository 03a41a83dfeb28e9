// SPDX-License-Identifier: MIT
#include "firmware/tasks/safety.hpp"

namespace echomap {
namespace tasks {

using protocol::MotionOutcome;

bool Safety::accepts(const protocol::ConfigureSafety& settings) {
  return settings.stall_ms <= protocol::kMaxStallMs &&
         settings.runaway_ticks <= protocol::kMaxRunawayTicks;
}

bool Safety::arm() {
  armed_ = !lifted();
  if (!motion_.moving()) {
    motion_.stop(MotionOutcome::kStopped);
  }
  return armed_;
}

void Safety::disarm(MotionOutcome reason) {
  armed_ = false;
  motion_.stop(reason);
}

void Safety::renew(uint16_t time_to_live_ms) {
  left_to_live_ms_ = time_to_live_ms == 0 ? protocol::kDefaultTimeToLiveMs : time_to_live_ms;
}

void Safety::tick() {
  contacts_.poll(wiring_.contacts_normally_closed);
  const uint8_t hazards = stopping_hazards();
  if (armed_ && lifted()) {
    disarm(MotionOutcome::kLifted);
  } else if (must_stop(contacts_.pressed(), contacts_.just_pressed())) {
    motion_.stop(MotionOutcome::kBumped);
  } else if (must_stop(hazards, hazards & sensors_.hazards().fresh())) {
    motion_.stop(MotionOutcome::kHazard);
  }
  if (left_to_live_ms_ != 0 && --left_to_live_ms_ == 0) {
    motion_.expire();
  }
}

void Safety::control() {
  if (!motion_.step()) {
    armed_ = false;
  }
}

uint8_t Safety::stopping_hazards() const {
  return sensors_.hazards().active() & (settings_.hazard_stops | protocol::kHazardWheelDrop);
}

bool Safety::lifted() const {
  return (sensors_.hazards().active() & protocol::kHazardWheelDrop) != 0;
}

/// Nothing is known of what lies behind, so the robot may back off from what is in front.
bool Safety::must_stop(uint8_t active, uint8_t fresh) const {
  return active != 0 && motion_.moving() &&
         (motion_.goes_forward() || (fresh != 0 && !motion_.only_backs_off()));
}

}  // namespace tasks
}  // namespace echomap
