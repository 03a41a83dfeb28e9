// SPDX-License-Identifier: MIT
#include "host/mapping/line_fit.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "host/geometry/angle.hpp"
#include "host/geometry/unit_vector.hpp"

namespace echomap::mapping {
namespace {

/// Mean of the points and the sums of their squares and products around it.
struct Moments {
  explicit Moments(std::span<const Eigen::Vector2d> points_m) {
    for (const Eigen::Vector2d& point_m : points_m) {
      mean_m += point_m / static_cast<double>(points_m.size());
    }
    for (const Eigen::Vector2d& point_m : points_m) {
      const Eigen::Vector2d off_m = point_m - mean_m;
      scatter_m2 += off_m * off_m.transpose();
    }
  }
  Eigen::Vector2d mean_m = Eigen::Vector2d::Zero();
  Eigen::Matrix2d scatter_m2 = Eigen::Matrix2d::Zero();
};

/// With u along the line from the foot of the origin: a turn of the line moves the offset by the
/// mean's u, and the mean itself is off by sd / sqrt(n).
Eigen::Matrix2d covariance_of(const Moments& moments,
                              double normal_rad,
                              std::size_t points,
                              double point_stddev_m) {
  const Eigen::Vector2d normal = geometry::unit_vector(normal_rad);
  const Eigen::Vector2d along = geometry::perpendicular(normal);
  const double along_m2 = along.dot(moments.scatter_m2 * along);
  const double across_m2 = normal.dot(moments.scatter_m2 * normal);
  const double spread_m2 = along_m2 - across_m2;
  const double variance_m2 = point_stddev_m * point_stddev_m;
  const double normal_rad2 = variance_m2 * (along_m2 + across_m2) / (spread_m2 * spread_m2);
  const double mean_along_m = along.dot(moments.mean_m);
  Eigen::Matrix2d covariance;
  covariance(0, 0) =
      variance_m2 / static_cast<double>(points) + mean_along_m * mean_along_m * normal_rad2;
  covariance(0, 1) = covariance(1, 0) = mean_along_m * normal_rad2;
  covariance(1, 1) = normal_rad2;
  return covariance;
}

Eigen::Vector2d foot_on(const FittedLine& line, const Eigen::Vector2d& point_m) {
  const Eigen::Vector2d normal = geometry::unit_vector(line.normal_rad);
  return point_m + (line.offset_m - normal.dot(point_m)) * normal;
}

}  // namespace

FittedLine fit_line(std::span<const Eigen::Vector2d> points_m, double point_stddev_m) {
  const Moments moments(points_m);
  if (!(moments.scatter_m2.trace() > 0.0)) {
    throw std::invalid_argument("a line takes two points in different places");
  }
  const Eigen::Matrix2d& scatter = moments.scatter_m2;
  FittedLine line;
  line.points = points_m.size();
  line.normal_rad = 0.5 * std::atan2(-2.0 * scatter(0, 1), scatter(1, 1) - scatter(0, 0));
  line.offset_m = geometry::unit_vector(line.normal_rad).dot(moments.mean_m);
  if (line.offset_m < 0.0) {
    line.offset_m = -line.offset_m;
    line.normal_rad = geometry::wrap_angle(line.normal_rad + std::numbers::pi);
  }
  line.covariance = covariance_of(moments, line.normal_rad, line.points, point_stddev_m);
  line.segment = {foot_on(line, points_m.front()), foot_on(line, points_m.back())};
  return line;
}

}  // namespace echomap::mapping
