// SPDX-License-Identifier: MIT
#include <avr/io.h>

#include "firmware/boards/arduino_uno/pins.hpp"
#include "firmware/boards/avr_common/parts.hpp"

namespace echomap {
namespace boards {

bool sda_is_low() { return (PINC & kSdaPin) == 0; }

void hold_scl() {
  PORTC &= static_cast<uint8_t>(~kSclPin);
  DDRC |= kSclPin;
}

void release_scl() {
  DDRC &= static_cast<uint8_t>(~kSclPin);
  PORTC |= kSclPin;
}

}  // namespace boards
}  // namespace echomap
