// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "hil_mock/rp2040/chip_link.hpp"
#include "hil_mock/runner/simulated_board.hpp"

namespace echomap::rp2040 {

/// What the Pico's pins do, as its chip has told last.
class PinSignals {
 public:
  /// Takes the signals of one event. Throws std::out_of_range for a pin that there is not.
  void take(Message& events);

  bool trigger_is_high() const;
  /// Whether the program holds this pin high.
  bool drives_high(std::uint8_t pin) const;
  /// The same as those of a SimulatedBoard.
  world::DriverInputs driver_inputs(runner::Wheel wheel, world::DriverInterface interface) const;
  double pan_pulse_us() const;

 private:
  std::array<world::PinSignal, 32> signals_{};
};

}  // namespace echomap::rp2040
