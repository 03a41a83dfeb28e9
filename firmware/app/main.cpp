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
    hal::lock_interrupts();
    while (!app::robot.has_work()) {
      hal::sleep_until_interrupt();
      hal::lock_interrupts();
    }
    hal::enable_interrupts();
  }
}
