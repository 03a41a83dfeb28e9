// SPDX-License-Identifier: MIT
#include "host/geometry/segment.hpp"

#include <algorithm>

namespace echomap::geometry {

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

}  // namespace echomap::geometry
