// SPDX-License-Identifier: MIT
#include "host/mapping/point_set.hpp"

namespace echomap::mapping {

std::vector<Eigen::Vector2d> some_of(const std::vector<Eigen::Vector2d>& points,
                                     std::size_t count) {
  if (points.size() <= count) {
    return points;
  }
  std::vector<Eigen::Vector2d> some;
  for (std::size_t i = 0; i < count; ++i) {
    some.push_back(points[i * points.size() / count]);
  }
  return some;
}

Eigen::Vector2d mean_of(const std::vector<Eigen::Vector2d>& points_m) {
  Eigen::Vector2d sum_m = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& point_m : points_m) {
    sum_m += point_m;
  }
  return sum_m / static_cast<double>(points_m.size());
}

}  // namespace echomap::mapping
