// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace drivers {

/// A sensor that says one number, on a spare pin: pulses of a Geiger tube, or a voltage. Sums up
/// since the reset, whatever pins do what in between.
class ScalarSensor {
 public:
  /// Takes the pulses that came since the last call; once a millisecond.
  void tick();
  /// Takes a conversion of the pin's voltage.
  void add(uint16_t conversion) {
    sum_ += conversion;
    ++samples_;
  }

  /// Pulses and conversions, modulo 2^32; how many of the latter, modulo 2^16.
  uint32_t sum() const { return sum_; }
  uint16_t samples() const { return samples_; }

 private:
  uint32_t sum_ = 0;
  uint16_t samples_ = 0;
  uint8_t pulses_ = 0;  ///< As the board had counted them at the last tick.
};

}  // namespace drivers
}  // namespace echomap
