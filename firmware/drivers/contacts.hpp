// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/hal/contacts.hpp"

namespace echomap {
namespace drivers {

/// The two bump contacts. A press counts at once; a release once it has lasted kReleaseMs, because
/// contacts bounce.
class Contacts {
 public:
  static constexpr uint8_t kReleaseMs = 20;

  /// Reads the pins; once a millisecond.
  void poll();

  bool left() const { return left_ms_ != 0; }
  bool right() const { return right_ms_ != 0; }
  bool any() const { return left() || right(); }
  /// True after the poll in which a contact closed.
  bool just_pressed() const { return just_pressed_; }

 private:
  uint8_t left_ms_ = 0;
  uint8_t right_ms_ = 0;
  bool just_pressed_ = false;
};

}  // namespace drivers
}  // namespace echomap
