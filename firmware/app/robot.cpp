// SPDX-License-Identifier: MIT
#include "firmware/app/robot.hpp"

#include "firmware/hal/watchdog.hpp"

namespace echomap {
namespace app {

Devices devices;
Robot robot(devices);

void Robot::start() {
  motion_.stop(protocol::MotionOutcome::kNone);
  sensors_.configure(configuration_.pins);
  hal::start_watchdog();
  command_.announce();
}

bool Robot::run_once() {
  devices_.work_waits = false;
  const bool received = command_.poll();
  heartbeat_.ran(tasks::Part::kLink);
  if (!devices_.scheduler.take_tick()) {
    return received;
  }
  run_tick();
  return true;
}

void Robot::run_tick() {
  sensors_.tick();
  safety_.tick();
  heartbeat_.ran(tasks::Part::kTick);
  if (devices_.scheduler.control_is_due()) {
    safety_.control();
    command_.control();
    heartbeat_.ran(tasks::Part::kControl);
  }
  protocol::Echo echo{};
  if (sweep_.tick(echo)) {
    telemetry_.add(echo);
  }
  telemetry_.tick();
  bulk_.tick();
}

}  // namespace app
}  // namespace echomap
