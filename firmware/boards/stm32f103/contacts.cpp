// SPDX-License-Identifier: MIT
#include "firmware/hal/contacts.hpp"

#include "firmware/boards/stm32f103/parts.hpp"
#include "firmware/boards/stm32f103/pins.hpp"

namespace echomap {
namespace boards {

void start_contacts() {
  pull_up(kContactLeftPin);
  pull_up(kContactRightPin);
}

}  // namespace boards

namespace hal {

uint8_t closed_contacts() {
  using namespace boards;
  return contact_bits(!level_of(kContactLeftPin), !level_of(kContactRightPin));
}

}  // namespace hal
}  // namespace echomap
