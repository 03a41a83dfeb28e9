// SPDX-License-Identifier: MIT
#include "firmware/hal/board.hpp"

#include "firmware/boards/rp2040/interrupt_lines.hpp"
#include "firmware/boards/rp2040/parts.hpp"

namespace echomap {
namespace hal {

void start_board() {
  boards::start_clock();
  boards::start_motors();
  boards::start_lines();
  boards::number_this_boot();
  boards::start_tick();
  boards::start_echo();
  boards::start_servo();
  boards::start_encoders();
  boards::start_contacts();
  boards::start_aux_pins();
  boards::start_converter();
  boards::start_uart();
  boards::start_usb();
}

}  // namespace hal
}  // namespace echomap
