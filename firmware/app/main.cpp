// SPDX-License-Identifier: MIT
#include "firmware/app/robot.hpp"
#include "firmware/hal/board.hpp"
#include "firmware/hal/interrupts.hpp"

int main() {
  using namespace echomap;
  hal::start_board();
  app::robot.start();
  hal::enable_interrupts();
  for (;;) {
    while (app::robot.run_once()) {
    }
    const hal::InterruptLock lock;
    if (!app::robot.has_work()) {
      hal::sleep_until_interrupt();
    }
  }
}
