// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "host/geometry/pose2.hpp"
#include "host/mapping/placed_reading.hpp"

namespace echomap::exports {

/// A reading of a sweep. A direction that the sonar has left out has no answer.
struct SweepReading {
  std::optional<double> range_m;  ///< From the sweep's axis; empty without echo.
  bool has_answered = false;      ///< Whether the sonar listened.

  bool operator==(const SweepReading&) const = default;
};

/// Readings of a sonar that has turned around one place in even steps, as formats for laser
/// scanners have them.
struct SonarSweep {
  geometry::Pose2 T_map_robot;  ///< Of the first reading.
  /// The axis around which the sonar has turned, towards the middle of the sweep.
  geometry::Pose2 T_map_sensor;
  double first_rad = 0.0;  ///< Bearing of the first reading in the sensor's frame.
  double step_rad = 0.0;   ///< From one to the next, counter-clockwise; 0 for a single reading.
  std::vector<SweepReading> readings;

  /// Bearing of a reading in the sensor's frame.
  double bearing_rad(std::size_t reading) const {
    return first_rad + step_rad * static_cast<double>(reading);
  }
};

/// The sweeps of a stop, in the order in which they were made. A sweep ends where the sonar turns
/// back, where a reading lies off its place in even steps by more than a quarter of one or half a
/// degree, or where the robot has moved on. An echo on the axis of its beam stays where it is, as
/// exactly as its bearing.
std::vector<SonarSweep> sweeps_of(const mapping::Scan& scan);

}  // namespace echomap::exports
