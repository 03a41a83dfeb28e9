// SPDX-License-Identifier: MIT
#include "firmware/drivers/analog_inputs.hpp"

#include <stddef.h>
#include <string.h>

#include "firmware/hal/adc.hpp"

namespace echomap {
namespace drivers {

void AnalogInputs::tick(const SparePins& pins) {
  uint16_t value = input_ == kRanges ? 0 : protocol::kNoRange;
  if (converting_ && !hal::conversion_done(value)) {
    return;
  }
  store(value);
  input_ = input_ == kRanges ? 0 : input_ + 1;
  const uint8_t pin =
      pins.find(input_ == kRanges ? protocol::kPinBattery : protocol::kPinRange0 + input_);
  converting_ = pin != SparePins::kNone;
  if (converting_) {
    hal::start_conversion(pin);
  }
}

void AnalogInputs::store(uint16_t value) {
  if (input_ == kRanges) {
    battery_ = value;
    return;
  }
  uint8_t* const channels =
      reinterpret_cast<uint8_t*>(&ranges_) + offsetof(protocol::Ranges, channel_0);
  memcpy(channels + input_ * sizeof(value), &value, sizeof(value));
}

}  // namespace drivers
}  // namespace echomap
