// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

#include "host/evaluation/map_agreement.hpp"
#include "host/geometry/polygon.hpp"

namespace echomap::evaluation {

/// Of drawn maps.
inline constexpr double kCellM = 0.1;

/// Adds the sides of an outline or of an obstacle to the walls.
inline void add_ring(const geometry::Polygon& ring, MapTruth& truth) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    truth.walls.push_back(geometry::side(ring, i));
  }
}

}  // namespace echomap::evaluation
