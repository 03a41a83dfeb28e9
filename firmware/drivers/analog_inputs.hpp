// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/drivers/spare_pins.hpp"
#include "protocol/telemetry_messages.hpp"

namespace echomap {
namespace drivers {

/// Infra-red range channels and battery, as the converter reads them: one input a millisecond, so
/// each is at most 9 ms old.
class AnalogInputs {
 public:
  static constexpr uint8_t kRanges = 8;

  /// Stores one conversion and starts the next; once a millisecond.
  void tick(const SparePins& pins);

  /// All channels; stamp and counts are left to who tells them.
  protocol::Ranges& ranges() { return ranges_; }
  /// 0 .. 1023; 0 where no pin measures it.
  uint16_t battery() const { return battery_; }

 private:
  void store(uint16_t value);

  protocol::Ranges ranges_ = {};
  uint16_t battery_ = 0;
  uint8_t input_ = 0;
  bool converting_ = false;
};

}  // namespace drivers
}  // namespace echomap
