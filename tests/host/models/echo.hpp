// SPDX-License-Identifier: MIT
#pragma once

#include "host/models/sensor_reading.hpp"

namespace echomap::models {

/// From a metre ahead.
inline constexpr SensorReading kEcho{1.0};

}  // namespace echomap::models
