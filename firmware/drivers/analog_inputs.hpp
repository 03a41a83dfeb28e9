// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/drivers/spare_pins.hpp"
#include "protocol/telemetry_messages.hpp"

namespace echomap {
namespace drivers {

/// Infra-red range channels and battery, as the converter reads them: a pin a millisecond, so that
/// each is at most as many milliseconds old as there are of them.
class AnalogInputs {
 public:
  /// Forgets all readings: the pins have other functions.
  void reset();
  /// Stores one conversion and starts the next; once a millisecond.
  void tick(const SparePins& pins);

  /// All channels, protocol::kNoRange for those without a pin; stamp and counts are left to who
  /// tells them.
  protocol::Ranges& ranges() { return ranges_; }
  /// 0 .. 1023; 0 where no pin measures it.
  uint16_t battery() const { return battery_; }

 private:
  void store(uint8_t function, uint16_t value);

  protocol::Ranges ranges_ = {};
  uint16_t battery_ = 0;
  uint8_t pin_ = 0;
  bool converting_ = false;
};

}  // namespace drivers
}  // namespace echomap
