// SPDX-License-Identifier: MIT
#include "host/geometry/main_direction.hpp"

#include <cmath>

#include "host/geometry/unit_vector.hpp"

namespace echomap::geometry {
namespace {

/// A wall's direction times four, which is the same for all four of a room's directions, with the
/// wall's length.
Eigen::Vector2d fourfold_m(const Segment& wall) {
  const Eigen::Vector2d along_m = wall.to_m - wall.from_m;
  return wall.length_m() * unit_vector(4.0 * std::atan2(along_m.y(), along_m.x()));
}

}  // namespace

double main_direction_rad(const std::vector<Segment>& walls) {
  constexpr double kMinAgreement = 0.2;
  // Of four times an angle of 7 degrees.
  constexpr double kMinCosine = 0.88;
  Eigen::Vector2d sum_m = Eigen::Vector2d::Zero();
  double length_m = 0.0;
  for (const Segment& wall : walls) {
    sum_m += fourfold_m(wall);
    length_m += wall.length_m();
  }
  if (length_m == 0.0 || sum_m.norm() < kMinAgreement * length_m) {
    return 0.0;
  }
  const Eigen::Vector2d mean = sum_m.normalized();
  Eigen::Vector2d near_m = Eigen::Vector2d::Zero();
  for (const Segment& wall : walls) {
    const Eigen::Vector2d direction_m = fourfold_m(wall);
    if (direction_m.dot(mean) >= kMinCosine * wall.length_m()) {
      near_m += direction_m;
    }
  }
  const Eigen::Vector2d main = near_m.isZero(0.0) ? mean : near_m;
  return std::atan2(main.y(), main.x()) / 4.0;
}

}  // namespace echomap::geometry
