// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <sim_avr.h>

#include "hil_mock/emulator/board_wiring.hpp"

namespace echomap::emulator {

/// Levels that the outside world puts on pins. simavr sets an input with a pull-up to 1 at every
/// write of PORTx or DDRx; each level is therefore also told to simavr as the pin's external state,
/// which wins over the pull-up.
class InputPins {
 public:
  explicit InputPins(avr_t& avr) : avr_(avr) {}

  /// Drives `pin` from now on.
  void set(Pin pin, bool level);
  /// Drives every pin again after a reset, which clears PINx.
  void redrive();

 private:
  struct Port {
    std::uint8_t driven = 0;
    std::uint8_t levels = 0;
  };

  void tell_external_state(char name, const Port& port);

  avr_t& avr_;
  std::map<char, Port> ports_;
};

}  // namespace echomap::emulator
