// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "hil_mock/emulator/avr_machine.hpp"
#include "hil_mock/emulator/board_wiring.hpp"
#include "hil_mock/emulator/output_pins.hpp"

namespace echomap::emulator {

/// The two wires of a bus with a device on it: pulled up, and where the device was cut off in the
/// middle of a byte, SDA held low until the program has clocked SCL through the rest of it by hand.
class HeldBus {
 public:
  /// `machine` outlives the bus.
  HeldBus(AvrMachine& machine, TwoWireWiring wiring);

  /// A device with pull-ups is on the bus.
  void pull_up();
  /// The device has so many bits left to send; above 0.
  void hold(unsigned bits);

 private:
  void on_direction();

  AvrMachine& machine_;
  TwoWireWiring wiring_;
  PortOutput clock_;
  bool clock_was_low_ = false;
  unsigned bits_ = 0;
};

}  // namespace echomap::emulator
