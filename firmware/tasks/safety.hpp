// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/control/wheel_motion.hpp"
#include "firmware/drivers/contacts.hpp"
#include "protocol/limits.hpp"

namespace echomap {
namespace tasks {

/// What may move, and for how long. Disarmed at the start; a motion ends when its time to live is
/// over or when a contact closes.
class Safety {
 public:
  constexpr explicit Safety(control::WheelMotion& motion) : motion_(motion) {}

  bool armed() const { return armed_; }
  void arm() { armed_ = true; }
  /// Stops the wheels too.
  void disarm();

  static bool accepts_time_to_live(uint16_t time_to_live_ms) {
    return time_to_live_ms <= protocol::kMaxTimeToLiveMs;
  }
  /// Whatever moves may go on for this long; 0 stands for the default.
  void renew(uint16_t time_to_live_ms);

  /// True when a pressed contact forbids a motion that goes forward as a whole.
  bool blocks(int32_t left, int32_t right) const { return contacts_.any() && left + right > 0; }
  const drivers::Contacts& contacts() const { return contacts_; }

  /// Once a millisecond.
  void tick();

 private:
  bool bumped() const;

  control::WheelMotion& motion_;
  drivers::Contacts contacts_;
  uint16_t left_to_live_ms_ = 0;
  bool armed_ = false;
};

}  // namespace tasks
}  // namespace echomap
