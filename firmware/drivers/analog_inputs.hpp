// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/drivers/scalar_sensor.hpp"
#include "firmware/drivers/spare_pins.hpp"
#include "protocol/telemetry_messages.hpp"

namespace echomap {
namespace drivers {

/// Infra-red range channels, battery and scalar sensor, as the converter reads them: a pin a
/// millisecond, so that each is at most as many milliseconds old as there are of them.
class AnalogInputs {
 public:
  static constexpr uint8_t kChannels = 8;

  /// Forgets all readings: the pins have other functions.
  void reset();
  /// Stores one conversion and starts the next; once a millisecond. Those of the scalar sensor's
  /// pin are `scalar`'s.
  void tick(const SparePins& pins, ScalarSensor& scalar);

  /// Infra-red channel 0 .. 7; protocol::kNoRange for one without a pin.
  uint16_t range(uint8_t channel) const { return ranges_[channel]; }
  /// 0 .. 1023; 0 where no pin measures it.
  uint16_t battery() const { return battery_; }

 private:
  void store(uint8_t function, uint16_t value, ScalarSensor& scalar);

  uint16_t ranges_[kChannels] = {};
  uint16_t battery_ = 0;
  uint8_t pin_ = 0;
  bool converting_ = false;
};

}  // namespace drivers
}  // namespace echomap
