// SPDX-License-Identifier: MIT
#include "host/papers/drive_path.hpp"

#include <cmath>

#include "host/geometry/angle.hpp"
#include "host/geometry/unit_vector.hpp"

namespace echomap::papers {

namespace {

double heading_rad(const Eigen::Vector2d& offset_m) {
  return std::atan2(offset_m.y(), offset_m.x());
}

}  // namespace

std::vector<geometry::Pose2> drive_path(const std::vector<Eigen::Vector2d>& points_m,
                                        const PathSteps& steps,
                                        double phase) {
  std::vector<geometry::Pose2> poses;
  double facing_rad = heading_rad(points_m.at(1) - points_m.at(0));
  for (std::size_t leg = 0; leg + 1 < points_m.size(); ++leg) {
    const Eigen::Vector2d offset_m = points_m[leg + 1] - points_m[leg];
    const double turn_rad = geometry::angle_between(facing_rad, heading_rad(offset_m));
    const int turns = static_cast<int>(std::ceil(std::abs(turn_rad) / steps.turn_rad));
    for (int i = 0; i < turns; ++i) {
      poses.emplace_back(
          points_m[leg].x(), points_m[leg].y(), facing_rad + turn_rad * (i + phase) / turns);
    }
    facing_rad = heading_rad(offset_m);
    for (double along_m = phase * steps.length_m; along_m < offset_m.norm();
         along_m += steps.length_m) {
      const Eigen::Vector2d at_m = points_m[leg] + along_m * geometry::unit_vector(facing_rad);
      poses.emplace_back(at_m.x(), at_m.y(), facing_rad);
    }
  }
  return poses;
}

}  // namespace echomap::papers
