// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include <Eigen/Core>

#include "host/geometry/segment.hpp"

namespace echomap::mapping {

/// A straight line: the points p with n . p = offset, n the unit vector at `normal_rad`; these two
/// are alpha and rho of the literature.
struct FittedLine {
  /// In (-pi, pi]; from the origin to the line.
  double normal_rad = 0.0;
  /// Not below 0.
  double offset_m = 0.0;
  /// Of (offset, normal), in m^2, m rad and rad^2.
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  /// From the foot of the first point to the foot of the last.
  geometry::Segment segment;
  std::size_t points = 0;
};

/// Total least squares: the line with the least squared distances at right angles to it, and how
/// sure it is where every coordinate of a point is off by `point_stddev_m` (to first order in it;
/// Arras and Siegwart 1997 for points of equal weight). Throws std::invalid_argument for fewer than
/// two points or points that are all in one place.
FittedLine fit_line(std::span<const Eigen::Vector2d> points_m, double point_stddev_m);

}  // namespace echomap::mapping
