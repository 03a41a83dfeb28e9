// SPDX-License-Identifier: MIT
#include "firmware/hal/contacts.hpp"

#include "firmware/boards/rp2040/parts.hpp"
#include "firmware/boards/rp2040/pins.hpp"

namespace echomap {
namespace boards {

void start_contacts() {
  pull_up(kContactLeftPin);
  pull_up(kContactRightPin);
}

}  // namespace boards

namespace hal {

uint8_t closed_contacts() {
  uint8_t closed = 0;
  if (!boards::level_of(boards::kContactLeftPin)) {
    closed |= kContactLeft;
  }
  if (!boards::level_of(boards::kContactRightPin)) {
    closed |= kContactRight;
  }
  return closed;
}

}  // namespace hal
}  // namespace echomap
