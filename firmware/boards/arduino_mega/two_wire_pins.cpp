// SPDX-License-Identifier: MIT
#include <avr/io.h>

#include "firmware/boards/arduino_mega/pins.hpp"
#include "firmware/boards/avr_common/parts.hpp"

namespace echomap {
namespace boards {

bool sda_is_low() { return (PIND & kSdaPin) == 0; }

void hold_scl() {
  PORTD &= static_cast<uint8_t>(~kSclPin);
  DDRD |= kSclPin;
}

void release_scl() {
  DDRD &= static_cast<uint8_t>(~kSclPin);
  PORTD |= kSclPin;
}

}  // namespace boards
}  // namespace echomap
