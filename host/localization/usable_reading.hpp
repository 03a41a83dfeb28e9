// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "host/localization/observation_model.hpp"
#include "host/localization/pose_gaussian.hpp"

namespace echomap::localization {

/// Where it came from and how far it went are numbers, and the range is not below 0. Silence is
/// usable.
inline bool is_usable(const RangeReading& reading) {
  return is_finite(reading.T_robot_sensor) &&
         (!reading.range_m || (std::isfinite(*reading.range_m) && *reading.range_m >= 0.0));
}

}  // namespace echomap::localization
