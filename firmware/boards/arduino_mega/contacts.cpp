// SPDX-License-Identifier: MIT
#include "firmware/hal/contacts.hpp"

#include <avr/io.h>

#include "firmware/boards/arduino_mega/pins.hpp"
#include "firmware/boards/avr_common/parts.hpp"

namespace echomap {
namespace boards {

void start_contacts() { PORTE |= kContactLeftPin | kContactRightPin; }

}  // namespace boards

namespace hal {

uint8_t closed_contacts() {
  const uint8_t open = PINE;
  return contact_bits((open & boards::kContactLeftPin) == 0,
                      (open & boards::kContactRightPin) == 0);
}

}  // namespace hal
}  // namespace echomap
