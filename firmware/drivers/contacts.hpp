// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/drivers/debounced_bits.hpp"
#include "firmware/hal/contacts.hpp"

namespace echomap {
namespace drivers {

/// The two bump contacts.
class Contacts {
 public:
  static constexpr uint8_t kMaxReleaseMs = DebouncedBits::kMaxReleaseMs;

  /// Reads the pins; once a millisecond.
  void poll() { bits_.update(hal::pressed_contacts()); }

  /// Bits of hal::Contact.
  uint8_t pressed() const { return bits_.active(); }
  /// Those that closed with the last poll.
  uint8_t just_pressed() const { return bits_.fresh(); }

 private:
  DebouncedBits bits_;
};

}  // namespace drivers
}  // namespace echomap
