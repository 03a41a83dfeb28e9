// SPDX-License-Identifier: MIT
#include "hil_mock/world/ray_cast.hpp"

#include <algorithm>
#include <cmath>

#include "host/geometry/angle.hpp"

namespace echomap::world {
namespace {

constexpr double kClearM = 1e-6;
constexpr double kPaneReflectance = 0.08;
/// Half of the opening of the sensors' lenses.
constexpr double kPaneLimitRad = geometry::radians(5.0);

}  // namespace

std::optional<RayHit> cast_ray(const FloorPlan& plan,
                               const Eigen::Vector2d& origin_m,
                               const Eigen::Vector2d& direction) {
  std::optional<RayHit> nearest;
  for (const Wall& wall : plan.walls()) {
    const auto distance_m = ray_distance_m(origin_m, direction, wall.segment);
    if (distance_m && *distance_m > kClearM && (!nearest || *distance_m < nearest->distance_m)) {
      nearest = RayHit{*distance_m, &wall, 0.0};
    }
  }
  if (nearest) {
    const double cosine = std::abs(direction.dot(left_normal(nearest->wall->segment)));
    nearest->incidence_rad = std::acos(std::min(1.0, cosine));
  }
  return nearest;
}

double light_back(const Surface& surface, double incidence_rad) {
  if (surface.material != Material::kGlass) {
    return surface.reflectance;
  }
  return incidence_rad <= kPaneLimitRad ? kPaneReflectance : 0.0;
}

bool sees(const FloorPlan& plan, const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m) {
  const double distance_m = (to_m - from_m).norm();
  const auto hit = cast_ray(plan, from_m, (to_m - from_m) / distance_m);
  return !hit || hit->distance_m > distance_m - kClearM;
}

}  // namespace echomap::world
