// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include <Eigen/Core>

#include "hil_mock/world/floor_plan.hpp"

namespace echomap::world {

/// Where a ray has met a wall.
struct RayHit {
  double distance_m = 0.0;
  const Wall* wall = nullptr;
  /// Between the ray and the wall's normal.
  double incidence_rad = 0.0;
};

/// The first wall on the way of a ray of unit `direction`; a wall that it starts on does not count.
std::optional<RayHit> cast_ray(const FloorPlan& plan,
                               const Eigen::Vector2d& origin_m,
                               const Eigen::Vector2d& direction);

/// Share of an infra-red sensor's light that a surface throws back to it. Of a pane that is the 4 %
/// of each of its sides (Fresnel's equations for an index of 1.5), and only from straight on; what
/// goes through is lost.
double light_back(const Surface& surface, double incidence_rad);

/// Share of light that the white paper throws back which data sheets measure sensors with.
inline constexpr double kPaperReflectance = 0.9;

/// Whether no wall stands between two points.
bool sees(const FloorPlan& plan, const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m);

}  // namespace echomap::world
