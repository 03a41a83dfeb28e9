// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

namespace echomap::sensors {

/// What a turning sonar has heard on one bearing; empty where nothing answered.
struct SweepReading {
  double bearing_rad = 0.0;
  std::optional<double> range_m;
};

/// The whole angle in which a sonar hears, from edge to edge, and the bounds between which it lies
/// with a confidence of 95 %.
struct ConeOpening {
  double opening_rad = 0.0;
  double low_rad = 0.0;
  double high_rad = 0.0;
};

}  // namespace echomap::sensors
