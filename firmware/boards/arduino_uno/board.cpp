// SPDX-License-Identifier: MIT
#include "firmware/hal/board.hpp"

#include "firmware/boards/arduino_uno/parts.hpp"
#include "firmware/boards/avr_common/boot.hpp"
#include "firmware/boards/avr_common/uart.hpp"

namespace echomap {
namespace hal {

void start_board() {
  boards::start_motors();
  boards::number_this_boot();
  boards::start_timer1();
  boards::start_tick();
  boards::start_encoders();
  boards::start_contacts();
  boards::start_uart();
}

}  // namespace hal
}  // namespace echomap
