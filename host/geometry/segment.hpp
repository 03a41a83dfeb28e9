// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

namespace echomap::geometry {

/// A straight piece from one end to the other, in metres of any one frame.
struct Segment {
  Eigen::Vector2d from_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d to_m = Eigen::Vector2d::Zero();

  double length_m() const { return (to_m - from_m).norm(); }
};

/// The point of the segment nearest to `point_m`; its end where the segment has no length.
Eigen::Vector2d nearest_point(const Segment& segment, const Eigen::Vector2d& point_m);

/// Distance from `point_m` to the nearest point of the segment.
double distance_m(const Segment& segment, const Eigen::Vector2d& point_m);

}  // namespace echomap::geometry
