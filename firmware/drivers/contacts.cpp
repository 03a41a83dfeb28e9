// SPDX-License-Identifier: MIT
#include "firmware/drivers/contacts.hpp"

namespace echomap {
namespace drivers {
namespace {

/// What is left of a contact's time as pressed; true when this press is a new one.
bool update(uint8_t& left_ms, bool closed) {
  const bool was_open = left_ms == 0;
  if (closed) {
    left_ms = Contacts::kReleaseMs;
  } else if (!was_open) {
    --left_ms;
  }
  return closed && was_open;
}

}  // namespace

void Contacts::poll() {
  const uint8_t closed = hal::pressed_contacts();
  const bool left_pressed = update(left_ms_, (closed & hal::kContactLeft) != 0);
  const bool right_pressed = update(right_ms_, (closed & hal::kContactRight) != 0);
  just_pressed_ = left_pressed || right_pressed;
}

}  // namespace drivers
}  // namespace echomap
