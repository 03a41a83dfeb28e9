// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "host/geometry/pose2.hpp"

namespace echomap::slam {

/// One beam of a scan. `range_m` is empty where nothing answered.
struct RangeBeam {
  double bearing_rad = 0.0;  ///< In the sensor's frame, counter-clockwise.
  std::optional<double> range_m;
};

/// Ranges taken together from one place: a laser's scan, a ring of sonars, one ping.
struct RangeScan {
  geometry::Pose2 T_robot_sensor;
  std::vector<RangeBeam> beams;
  double beam_opening_rad = 0.0;  ///< The whole cone of a beam; 0 for a laser.
  double max_range_m = 0.0;       ///< What is as far as this or farther does not answer.
};

/// Where the answers of a scan lie, on the axes of their beams, in the robot's frame. In the order
/// of the beams; those without answer, or with one beyond `most_range_m`, are left out.
std::vector<Eigen::Vector2d> end_points_m(const RangeScan& scan, double most_range_m);

/// The same points in another frame.
std::vector<Eigen::Vector2d> in_frame_a_m(const geometry::Pose2& T_a_b,
                                          std::span<const Eigen::Vector2d> points_b_m);

}  // namespace echomap::slam
