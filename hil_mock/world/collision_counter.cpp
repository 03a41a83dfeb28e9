// SPDX-License-Identifier: MIT
#include "hil_mock/world/collision_counter.hpp"

#include <cmath>

namespace echomap::world {
namespace {

/// A wall that is let go for longer is met anew.
constexpr double kApartS = 0.5;
/// Twice the speed at which any of the bundled profiles drives into what it does not see.
constexpr double kHardestBumpMPerS = 0.5;
/// Rubbing along a wall is no collision.
constexpr double kRubMPerS = 0.05;

}  // namespace

void CollisionCounter::note(const Eigen::Vector2d& push_m, double dt_s) {
  if (push_m.norm() <= 1e-9 * dt_s) {
    free_s_ += dt_s;
    return;
  }
  const bool is_new = free_s_ > kApartS;
  const bool hard = is_hard(push_m, dt_s);
  free_s_ = 0.0;
  if (is_new) {
    is_hard_ = false;
    ++collisions_.bumps;
  }
  if (hard && !is_hard_) {
    is_hard_ = true;
    --collisions_.bumps;
    ++collisions_.hard;
  }
}

bool CollisionCounter::is_hard(const Eigen::Vector2d& push_m, double dt_s) const {
  const double speed_m_per_s = push_m.norm() / dt_s;
  const double bearing_rad = std::atan2(-push_m.y(), -push_m.x());
  const bool by_bumper = body_.has_bumpers && std::abs(bearing_rad) <= body_.bumper_end_rad;
  return speed_m_per_s > (by_bumper ? kHardestBumpMPerS : kRubMPerS);
}

}  // namespace echomap::world
