// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "host/geometry/polygon.hpp"

namespace echomap::geometry {

/// The way with fewer points, both ends kept: no dropped point is farther than `tolerance_m` from
/// the piece that replaces it (Douglas and Peucker 1973).
std::vector<Eigen::Vector2d> simplified_way(const std::vector<Eigen::Vector2d>& way_m,
                                            double tolerance_m);

/// The same for a closed outline, cut at two corners far apart, which stay. What is left may have
/// sides that cross (polygon_fault), or fewer than three corners; then single sides can be split.
class SimplifiedRing {
 public:
  SimplifiedRing(const Polygon& ring, double tolerance_m);

  /// The corners that are left, in their order.
  Polygon polygon() const;
  /// Keeps the dropped corner that is farthest from a side of `polygon()`, which becomes two; false
  /// where none off that side was dropped.
  bool split(std::size_t side);

 private:
  std::vector<Eigen::Vector2d> way_m_;  ///< Closed: the first corner stands at its end again.
  std::vector<std::size_t> kept_;
};

/// The corners of a SimplifiedRing.
Polygon simplified_polygon(const Polygon& polygon, double tolerance_m);

}  // namespace echomap::geometry
