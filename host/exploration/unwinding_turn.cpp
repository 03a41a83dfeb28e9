// SPDX-License-Identifier: MIT
#include "host/exploration/unwinding_turn.hpp"

#include <cmath>
#include <numbers>

#include "host/geometry/angle.hpp"

namespace echomap::exploration {

double unwinding_turn_rad(double heading_rad, double target_rad) {
  const double shortest_rad = geometry::angle_between(heading_rad, target_rad);
  return std::abs(shortest_rad) <= 0.5 * std::numbers::pi ? shortest_rad : target_rad - heading_rad;
}

}  // namespace echomap::exploration
