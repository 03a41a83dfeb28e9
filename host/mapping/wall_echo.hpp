// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace echomap::mapping {

/// One range with an answer, and where it was taken.
struct Echo {
  Eigen::Vector2d sensor_m = Eigen::Vector2d::Zero();
  double axis_rad = 0.0;  ///< Where the middle of the beam points.
  double range_m = 0.0;
  double beam_half_angle_rad = 0.0;  ///< 0 for a laser's beam.

  /// Where the answer lies if it came from the beam's middle.
  Eigen::Vector2d middle_m() const;
};

/// A straight wall: the points p with n . p = offset, n the unit vector at `normal_rad`, which
/// points away from the side that is seen.
struct WallLine {
  double normal_rad = 0.0;
  double offset_m = 0.0;
};

/// What a beam would measure of a wall, and how that changes with the wall.
struct WallView {
  double range_m = 0.0;
  /// Derivatives by the line's normal_rad and offset_m.
  Eigen::Vector2d by_line = Eigen::Vector2d::Zero();
  /// Where in the beam the wall is nearest.
  double contact_rad = 0.0;
};

/// The nearest point of the wall within the beam answers: the foot of the perpendicular if that is
/// in the beam, else the wall at the beam's edge (Leonard and Durrant-Whyte 1992 for the first). A
/// wall seen at less than a grazing angle of 15 degrees is taken as seen at that angle.
WallView view_of_wall(const Echo& echo, const WallLine& line);

/// The wall with that normal whose nearest point within the beam answered.
WallLine wall_through(const Echo& echo, double normal_rad);

}  // namespace echomap::mapping
