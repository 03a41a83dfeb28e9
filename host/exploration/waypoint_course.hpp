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

/// A course where nobody has made one; ours.
struct CourseAroundParams {
  double cell_m = 0.05;
  /// How far from the sides the corners' waypoints are: a robot of 10 cm has room to turn.
  double inset_m = 0.25;
  /// On longer sides there are waypoints between those of the corners, no farther apart than this:
  /// as many moves as a waypoint has do not lead farther.
  double spacing_m = 1.5;
  /// Of the grid around the outline.
  double margin_m = 0.2;
};

/// The four corners of the box around a room's outline, counter-clockwise from the one nearest to
/// the start, and the start again: what the paper does in its playground, for a room of which only
/// the outline is known. Waypoints that the outline has no room for are left out; its sides are the
/// known walls. Throws std::invalid_argument for parameters without sense or an outline of no
/// extent.
WaypointCourse course_around(const geometry::Polygon& outline_m,
                             const geometry::Pose2& T_outline_start,
                             const CourseAroundParams& params = {});

}  // namespace echomap::exploration
