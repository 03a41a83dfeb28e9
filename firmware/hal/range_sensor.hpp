// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

namespace echomap {
namespace hal {

/// Speed of sound that `RangeReading::range_mm` is by, in 0.1 m/s: dry air at 20 degrees C.
constexpr uint16_t kRangeSoundDmPerS = 3432;

/// What a sensor says that measures ranges by itself, when it likes.
struct RangeReading {
  enum class State : uint8_t { kAbsent, kNothing, kRange };
  State state;               ///< kNothing: it measures, and has nothing within its reach.
  uint16_t range_mm;         ///< With kRange; at most 5,600, which no 16-bit flight time outgrows.
  uint8_t greatest_age_ms;  ///< No reading is older: what it saw so long ago is over.
};

/// True on a board whose sonar is such a sensor; hal/sonar.hpp is then never called.
bool has_range_sensor();
/// The last reading.
RangeReading read_range();

}  // namespace hal
}  // namespace echomap
