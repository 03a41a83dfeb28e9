// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include "host/geometry/cell_index.hpp"
#include "host/geometry/segment.hpp"
#include "host/geometry/whole_cell.hpp"

namespace echomap::mapping {

/// Visits the cells that a straight piece runs through, up to slivers of a fifth of a cell, some of
/// them more than once.
template <class Visit>
void visit_along(const geometry::Segment& piece, double resolution_m, Visit&& visit) {
  constexpr double kStepsPerCell = 5.0;
  const int steps = 1 + static_cast<int>(kStepsPerCell * piece.length_m() / resolution_m);
  for (int i = 0; i <= steps; ++i) {
    const Eigen::Vector2d point_m =
        piece.from_m + static_cast<double>(i) / steps * (piece.to_m - piece.from_m);
    visit(geometry::CellIndex{geometry::whole_cell(point_m.x() / resolution_m),
                              geometry::whole_cell(point_m.y() / resolution_m)});
  }
}

}  // namespace echomap::mapping
