// SPDX-License-Identifier: MIT
#include "firmware/hal/board.hpp"

#include "firmware/boards/stm32f103/parts.hpp"

namespace echomap {
namespace hal {

void start_board() {
  boards::start_clock();
  boards::start_motors();
  boards::number_this_boot();
  boards::start_tick();
  boards::start_echo();
  boards::start_servo();
  boards::start_encoders();
  boards::start_contacts();
  boards::start_aux_pins();
  boards::start_converter();
  boards::start_uart();
}

}  // namespace hal
}  // namespace echomap
