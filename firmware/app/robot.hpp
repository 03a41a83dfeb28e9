// SPDX-License-Identifier: MIT
#pragma once

#include "firmware/app/settings.hpp"
#include "firmware/tasks/command.hpp"
#include "firmware/tasks/heartbeat.hpp"
#include "firmware/tasks/scheduler.hpp"
#include "firmware/tasks/telemetry.hpp"

namespace echomap {
namespace app {

/// What interrupts talk to. Apart from the rest, because all of it starts as zero: initial values
/// would stand in the program a second time.
struct Devices {
  drivers::WheelEncoders encoders;
  drivers::Sonar sonar;
  drivers::SerialPort port;
  tasks::Scheduler scheduler;
  /// An interrupt has left work for the main loop; edges of the encoders leave none.
  volatile bool work_waits = false;
};

/// The whole program above its devices, put together.
class Robot {
 public:
  constexpr explicit Robot(Devices& devices) : devices_(devices) {}

  /// After hal::start_board and before interrupts are unlocked.
  void start();
  /// Does what is due; false when there was nothing to do.
  bool run_once();
  /// Asked with interrupts locked: false means that the board may sleep.
  bool has_work() const { return devices_.work_waits; }

 private:
  void run_tick();

  Devices& devices_;
  protocol::Configuration configuration_ = kDefaultConfiguration;
  control::WheelMotion motion_{devices_.encoders, configuration_.drive, configuration_.safety};
  tasks::Sensors sensors_{configuration_.pins, configuration_.sensors, configuration_.scalar};
  drivers::PanDrive pan_{configuration_.pan, sensors_.pins()};
  control::ScanSweep sweep_{devices_.encoders, devices_.sonar, pan_, configuration_.sonar};
  tasks::Safety safety_{motion_, sensors_, configuration_.safety, configuration_.wiring};
  tasks::FrameSender sender_{devices_.port};
  protocol::ReceiveCounters received_;
  tasks::Telemetry telemetry_{{devices_.encoders,
                               devices_.port,
                               motion_,
                               sweep_,
                               sensors_,
                               safety_,
                               received_,
                               configuration_},
                              sender_};
  tasks::Bulk bulk_{sender_, configuration_};
  tasks::Command command_{{devices_.port,
                           sender_,
                           motion_,
                           sweep_,
                           sensors_,
                           safety_,
                           telemetry_,
                           received_,
                           configuration_,
                           bulk_}};
  tasks::Heartbeat heartbeat_;
};

/// The one robot and its devices, to which the board's events go.
extern Devices devices;
extern Robot robot;

}  // namespace app
}  // namespace echomap
