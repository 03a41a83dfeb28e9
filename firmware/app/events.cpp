// SPDX-License-Identifier: MIT
#include "firmware/hal/events.hpp"

#include "firmware/app/robot.hpp"

namespace echomap {
namespace hal {

void on_tick() {
  app::devices.scheduler.on_tick();
  app::devices.work_waits = true;
}

void on_echo_edge(bool high, uint32_t stamp_half_us) {
  app::devices.sonar.on_echo_edge(high, stamp_half_us);
}

void on_byte_received(uint8_t byte) {
  app::devices.port.on_received(byte);
  app::devices.work_waits = true;
}

void on_receive_overrun() { app::devices.port.on_overrun(); }

bool next_byte_to_send(uint8_t& byte) { return app::devices.port.on_send_ready(byte); }

}  // namespace hal
}  // namespace echomap
