// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "host/geometry/polygon.hpp"

namespace echomap::geometry {

/// A closed outline with fewer corners, cut at two corners far apart, which stay: no dropped corner
/// is farther than `tolerance_m` from the side that replaces it (Douglas and Peucker 1973). What is
/// left may have sides that cross (polygon_fault), or fewer than three corners; then single sides
/// can be split.
class SimplifiedRing {
 public:
  SimplifiedRing(const Polygon& ring, double tolerance_m);

  /// The corners that are left, in their order.
  Polygon polygon() const;
  /// Keeps the dropped corner that is farthest from a side of `polygon()`, which becomes two; false
  /// where none off that side was dropped.
  bool split(std::size_t side);

 private:
  std::vector<Eigen::Vector2d> polyline_m_;  ///< Closed: the first corner stands at its end again.
  std::vector<std::size_t> kept_;
};

}  // namespace echomap::geometry
