// SPDX-License-Identifier: MIT
#include "firmware/hal/board.hpp"

#include "firmware/boards/avr_common/boot.hpp"
#include "firmware/boards/avr_common/parts.hpp"
#include "firmware/boards/avr_common/uart.hpp"

namespace echomap {
namespace hal {

void start_board() {
  boards::start_motors();
  boards::number_this_boot();
  boards::start_frame_timer();
  boards::start_tick();
  boards::start_encoders();
  boards::start_contacts();
  boards::start_uart();
}

}  // namespace hal
}  // namespace echomap
