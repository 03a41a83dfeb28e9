// SPDX-License-Identifier: MIT
#include "host/geometry/segment.hpp"

#include <algorithm>

namespace echomap::geometry {
namespace {

/// Sides of `line` on which the ends of `other` lie, as signed areas.
Eigen::Vector2d sides(const Segment& line, const Segment& other) {
  const Eigen::Vector2d along = line.to_m - line.from_m;
  return {cross(along, other.from_m - line.from_m), cross(along, other.to_m - line.from_m)};
}

bool ends_on(const Segment& first, const Segment& second) {
  constexpr double kTouchM = 1e-9;
  return (nearest_point(first, second.from_m) - second.from_m).norm() < kTouchM ||
         (nearest_point(first, second.to_m) - second.to_m).norm() < kTouchM;
}

}  // namespace

Eigen::Vector2d nearest_point(const Segment& segment, const Eigen::Vector2d& point_m) {
  const Eigen::Vector2d along = segment.to_m - segment.from_m;
  const double squared_length = along.squaredNorm();
  if (squared_length == 0.0) {
    return segment.from_m;
  }
  const double share = along.dot(point_m - segment.from_m) / squared_length;
  return segment.from_m + std::clamp(share, 0.0, 1.0) * along;
}

double distance_m(const Segment& segment, const Eigen::Vector2d& point_m) {
  return (nearest_point(segment, point_m) - point_m).norm();
}

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

Eigen::Vector2d left_normal(const Segment& segment) {
  const Eigen::Vector2d along = segment.to_m - segment.from_m;
  return Eigen::Vector2d(-along.y(), along.x()).normalized();
}

std::optional<double> ray_distance_m(const Eigen::Vector2d& origin_m,
                                     const Eigen::Vector2d& direction,
                                     const Segment& segment) {
  const Eigen::Vector2d along = segment.to_m - segment.from_m;
  const double slope = cross(direction, along);
  if (slope == 0.0) {
    return std::nullopt;
  }
  const Eigen::Vector2d offset = segment.from_m - origin_m;
  const double distance_m = cross(offset, along) / slope;
  const double share = cross(offset, direction) / slope;
  if (distance_m < 0.0 || share < 0.0 || share > 1.0) {
    return std::nullopt;
  }
  return distance_m;
}

bool cross_properly(const Segment& first, const Segment& second) {
  const Eigen::Vector2d of_second = sides(first, second);
  const Eigen::Vector2d of_first = sides(second, first);
  return of_second.x() * of_second.y() < 0.0 && of_first.x() * of_first.y() < 0.0;
}

bool touch(const Segment& first, const Segment& second) {
  return cross_properly(first, second) || ends_on(first, second) || ends_on(second, first);
}

}  // namespace echomap::geometry
