// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

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

/// z component of the cross product: positive where `b` lies counter-clockwise of `a`.
double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b);

/// Unit vector that points to the left of the way from `from_m` to `to_m`.
Eigen::Vector2d left_normal(const Segment& segment);

/// Distance along a ray of unit `direction` to the segment; empty where the ray misses it.
std::optional<double> ray_distance_m(const Eigen::Vector2d& origin_m,
                                     const Eigen::Vector2d& direction,
                                     const Segment& segment);

/// Whether the two cross in a point that is inside of both; touching does not count.
bool cross_properly(const Segment& first, const Segment& second);

/// Whether the two have any point in common.
bool touch(const Segment& first, const Segment& second);

}  // namespace echomap::geometry
