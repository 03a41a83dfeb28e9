// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "hil_mock/ev3/lego_sensor.hpp"

namespace echomap::ev3 {

/// What looks for walls at in4.
enum class RangeSensor : std::uint8_t {
  kUltrasonic,  ///< LEGO 45504: millimetres, measures every 50 ms.
  kNxtSonar,    ///< LEGO 9846: whole centimetres, asked every 100 ms.
  kInfrared,    ///< LEGO 45509: percent of 70 cm, measures every 50 ms.
};

/// How such a sensor tells a range.
struct RangeSensorFacts {
  LegoSensorKind kind;
  double units_per_m;
  double max_range_m;
  long nothing;  ///< What it tells when there is nothing within its range.
  std::int64_t period_ns;

  /// What it tells of a range in metres.
  long told(double range_m) const;
};

/// Facts of LEGO and of lego-linux-drivers. Assumed are the periods of 45504 and 45509, and that
/// the brightness by which 45509 judges is that of a white wall.
RangeSensorFacts facts_of(RangeSensor sensor);

}  // namespace echomap::ev3
