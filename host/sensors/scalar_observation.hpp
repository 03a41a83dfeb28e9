// SPDX-License-Identifier: MIT
#pragma once

#include "host/sensors/wheel_travel.hpp"
#include "host/time/robot_time.hpp"

namespace echomap::sensors {

/// One reading of a scalar sensor: pulses of a Geiger tube, or a level of light or gas.
struct ScalarObservation {
  time::RobotTime stamp;
  WheelTravel travel;
  double count = 0.0;    ///< Pulses since the reading before, or the level in the sensor's unit.
  double dwell_s = 0.0;  ///< For how long pulses were counted; 0 for a level.
};

}  // namespace echomap::sensors
