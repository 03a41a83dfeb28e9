// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "protocol/command_messages.hpp"

namespace echomap {
namespace drivers {

/// The board's spare pins by their functions.
class SparePins {
 public:
  /// `settings` is where the active ones stand.
  constexpr explicit SparePins(protocol::ConfigurePins& settings) : settings_(settings) {}

  /// True when every pin of the board can do what it shall, none of them is taken, and there is
  /// none beyond its last.
  bool accepts(const protocol::ConfigurePins& settings) const;
  /// Takes settings that `accepts` has granted.
  void configure(const protocol::ConfigurePins& settings);

  /// True when none of these, a bit each, has a function.
  bool can_take(uint16_t pins) const;
  /// Leaves these to a motor bridge, which drives them already, and has those back that it had.
  void take(uint16_t pins);

  /// True for a range channel, the battery or a scalar sensor that is a voltage.
  static bool is_analog(uint8_t function) {
    return function == protocol::kPinBattery || function == protocol::kPinScalarLevel ||
           (function & 0xF8) == protocol::kPinRange0;
  }

  /// True when one is in use that the two-wire bus would take.
  bool use_twi_pins() const { return use_twi_pins_; }

  /// Pins up to the last that does something; what pin N does.
  uint8_t used() const { return used_; }
  uint8_t function(uint8_t pin) const;

  /// Bits of protocol::Hazard whose pins now have the level that means one.
  uint8_t active_hazards() const;

  /// True when each phase of a stepper has its pin.
  bool has_stepper() const;
  /// Levels of the phases, A in bit 0.
  void set_stepper_phases(uint8_t levels) const;

 private:
  bool is_taken(uint8_t pin) const { return (taken_ >> pin & 1) != 0; }

  protocol::ConfigurePins& settings_;
  uint16_t taken_ = 0;
  uint8_t used_ = 0;
  bool use_twi_pins_ = false;
};

}  // namespace drivers
}  // namespace echomap
