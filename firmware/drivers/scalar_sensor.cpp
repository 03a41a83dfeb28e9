// SPDX-License-Identifier: MIT
#include "firmware/drivers/scalar_sensor.hpp"

#include "firmware/hal/pulses.hpp"

namespace echomap {
namespace drivers {

void ScalarSensor::tick() {
  const uint8_t counted = hal::counted_pulses();
  sum_ += static_cast<uint8_t>(counted - pulses_);
  pulses_ = counted;
}

}  // namespace drivers
}  // namespace echomap
