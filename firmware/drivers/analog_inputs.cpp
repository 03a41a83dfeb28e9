// SPDX-License-Identifier: MIT
#include "firmware/drivers/analog_inputs.hpp"

#include "firmware/hal/adc.hpp"

namespace echomap {
namespace drivers {

void AnalogInputs::reset() {
  for (uint16_t& range : ranges_) {
    range = protocol::kNoRange;
  }
  battery_ = 0;
  pin_ = 0;
  converting_ = false;
}

void AnalogInputs::tick(const SparePins& pins, ScalarSensor& scalar) {
  uint16_t value = 0;
  if (converting_) {
    if (!hal::conversion_done(value)) {
      return;
    }
    store(pins.function(pin_), value, scalar);
  }
  converting_ = false;
  for (uint8_t tried = 0; tried < pins.used() && !converting_; ++tried) {
    if (++pin_ >= pins.used()) {
      pin_ = 0;
    }
    converting_ = SparePins::is_analog(pins.function(pin_));
  }
  if (converting_) {
    hal::start_conversion(pin_);
  }
}

void AnalogInputs::store(uint8_t function, uint16_t value, ScalarSensor& scalar) {
  if (function == protocol::kPinBattery) {
    battery_ = value;
  } else if (function == protocol::kPinScalarLevel) {
    scalar.add(value);
  } else {
    ranges_[function - protocol::kPinRange0] = value;
  }
}

}  // namespace drivers
}  // namespace echomap
