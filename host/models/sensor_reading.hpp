// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <optional>

#include <Eigen/Core>

namespace echomap::models {

/// What one range sensor has read; empty where nothing answered.
struct SensorReading {
  std::optional<double> range_m;
};

/// A point as the sensor sees it: how far, and how far off the sensor's axis.
struct PolarPoint {
  double range_m = 0.0;
  double off_axis_rad = 0.0;
};

/// Of a point in the sensor's frame: x along the axis.
inline PolarPoint polar_point(const Eigen::Vector2d& point_m) {
  return {point_m.norm(), std::atan2(point_m.y(), point_m.x())};
}

}  // namespace echomap::models
