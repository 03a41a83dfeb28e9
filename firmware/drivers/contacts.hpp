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

  /// Reads the pins; once a millisecond. `normally_closed` has the bits of those that open when
  /// they are pressed: a broken wire of one of these is a press.
  void poll(uint8_t normally_closed) {
    bits_.update(static_cast<uint8_t>(hal::closed_contacts() ^ normally_closed));
  }
  /// Nothing counts that was read before.
  void restart() { bits_ = DebouncedBits(); }

  /// Bits of hal::Contact.
  uint8_t pressed() const { return bits_.active(); }
  /// Those that were pressed with the last poll.
  uint8_t just_pressed() const { return bits_.fresh(); }

 private:
  DebouncedBits bits_;
};

}  // namespace drivers
}  // namespace echomap
