// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "host/geometry/cell_index.hpp"
#include "host/mapping/occupancy_grid.hpp"

namespace echomap::mapping {

/// The cells of a lattice that touch a rectangle, metres.
CellBounds cells_around(const Eigen::Array2d& low_m,
                        const Eigen::Array2d& high_m,
                        double resolution_m);

/// A whole number for each cell of a rectangle that grows, all of them held, 0 at first.
class CellSums {
 public:
  /// The cells that may not be 0.
  const CellBounds& bounds() const { return bounds_; }

  /// 0 beyond the bounds.
  int at(geometry::CellIndex cell) const {
    return bounds_.holds(cell) ? values_[bounds_.index(cell)] : 0;
  }
  /// The cell has to be within the bounds.
  void add(geometry::CellIndex cell, int change) { values_[bounds_.index(cell)] += change; }

  /// Whether there is memory for the rectangle, too.
  bool can_hold(const CellBounds& bounds) const;
  /// Grows so that the rectangle is within the bounds.
  void hold(const CellBounds& bounds);

 private:
  CellBounds bounds_;
  std::vector<std::int32_t> values_;
};

}  // namespace echomap::mapping
