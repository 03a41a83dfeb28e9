// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "host/exploration/waypoint_course.hpp"

namespace echomap::bench {

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
/// known walls. Throws std::invalid_argument for invalid parameters or an outline of no extent.
exploration::WaypointCourse course_around(const geometry::Polygon& outline_m,
                                          const geometry::Pose2& T_outline_start,
                                          const CourseAroundParams& params = {});

/// Writes what strategies::load_course reads. Throws files::FileError.
void write_course(const std::filesystem::path& path, const exploration::WaypointCourse& course);

}  // namespace echomap::bench
