// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <numbers>
#include <random>
#include <vector>

#include "host/geometry/polygon.hpp"
#include "host/geometry/unit_vector.hpp"

namespace echomap::tests {

/// A polygon without faults, star-shaped around the origin and with corners 0.5 to 3 m from it.
inline geometry::Polygon random_polygon(std::mt19937& random, std::size_t corners) {
  std::uniform_real_distribution<double> range_m(0.5, 3.0);
  std::uniform_real_distribution<double> jitter(0.1, 0.9);
  geometry::Polygon polygon;
  for (std::size_t i = 0; i < corners; ++i) {
    const double share = (static_cast<double>(i) + jitter(random)) / static_cast<double>(corners);
    polygon.emplace_back(range_m(random) * geometry::unit_vector(2.0 * std::numbers::pi * share));
  }
  return polygon;
}

}  // namespace echomap::tests
