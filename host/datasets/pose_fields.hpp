// SPDX-License-Identifier: MIT
#pragma once

#include "host/datasets/field_cursor.hpp"
#include "host/geometry/pose2.hpp"

namespace echomap::datasets {

/// The units of a pose's three fields.
struct PoseUnits {
  double length_m = 1.0;
  double angle_rad = 1.0;
};

/// Reads x, y and heading; `name` stands for each of them in an error.
inline geometry::Pose2 read_pose(FieldCursor& fields,
                                 const char* name,
                                 const PoseUnits& units = {}) {
  const double x_m = fields.number(name) * units.length_m;
  const double y_m = fields.number(name) * units.length_m;
  const double heading_rad = fields.number(name) * units.angle_rad;
  return {x_m, y_m, heading_rad};
}

}  // namespace echomap::datasets
