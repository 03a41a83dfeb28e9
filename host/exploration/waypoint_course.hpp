// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "host/geometry/polygon.hpp"
#include "host/geometry/pose2.hpp"
#include "host/geometry/segment.hpp"
#include "host/mapping/occupancy_grid.hpp"

namespace echomap::exploration {

/// A place to go to.
struct Waypoint {
  std::string name;
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();
};

/// What a robot knows of its room beforehand (Hennessey et al., sections II.B and II.D), in a frame
/// of the course's own.
struct WaypointCourse {
  std::string name;
  geometry::Pose2 T_course_start;  ///< Where the robot starts.
  mapping::CellBounds cells;       ///< Of the grid; cell (0, 0) begins at the course's origin.
  double cell_m = 0.05;
  std::vector<geometry::Segment> known_walls;
  std::vector<Waypoint> waypoints;  ///< In the order of the phases.
};

}  // namespace echomap::exploration
