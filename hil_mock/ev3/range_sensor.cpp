// SPDX-License-Identifier: MIT
#include "hil_mock/ev3/range_sensor.hpp"

#include <algorithm>
#include <cmath>

namespace echomap::ev3 {

long RangeSensorFacts::told(double range_m) const {
  return range_m > max_range_m ? nothing : std::min(std::lround(range_m * units_per_m), nothing);
}

RangeSensorFacts facts_of(RangeSensor sensor) {
  constexpr std::int64_t kMs = 1'000'000;
  switch (sensor) {
    case RangeSensor::kNxtSonar:
      return {{"lego-nxt-us", "US-DIST-CM", 0}, 100.0, 2.5, 255, 100 * kMs};
    case RangeSensor::kInfrared:
      return {{"lego-ev3-ir", "IR-PROX", 0}, 100.0 / 0.7, 0.7, 100, 50 * kMs};
    case RangeSensor::kUltrasonic:
      break;
  }
  return {{"lego-ev3-us", "US-DIST-CM", 1}, 1000.0, 2.5, 2550, 50 * kMs};
}

}  // namespace echomap::ev3
