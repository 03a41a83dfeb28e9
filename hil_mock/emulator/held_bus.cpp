// SPDX-License-Identifier: GPL-3.0-or-later
#include "hil_mock/emulator/held_bus.hpp"

#include "hil_mock/emulator/chip_modules.hpp"

namespace echomap::emulator {

HeldBus::HeldBus(AvrMachine& machine, TwoWireWiring wiring)
    : machine_(machine), wiring_(wiring), clock_(machine.core(), wiring.scl) {
  machine_.hooks().after_write(find_port(machine_.core(), wiring_.scl.port).r_ddr,
                               [this] { on_direction(); });
}

void HeldBus::pull_up() {
  machine_.pins().set(wiring_.sda, true);
  machine_.pins().set(wiring_.scl, true);
}

void HeldBus::hold(unsigned bits) {
  bits_ = bits;
  machine_.pins().set(wiring_.sda, false);
  machine_.two_wire().hold(true);
}

/// The device goes on to its next bit when the clock falls.
void HeldBus::on_direction() {
  const bool low = clock_.is_driven() && !clock_.level();
  const bool falls = low && !clock_was_low_;
  clock_was_low_ = low;
  if (falls && bits_ != 0 && --bits_ == 0) {
    machine_.pins().set(wiring_.sda, true);
    machine_.two_wire().hold(false);
  }
}

}  // namespace echomap::emulator
