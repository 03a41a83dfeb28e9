// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "host/geometry/cell_index.hpp"
#include "host/mapping/occupancy_grid.hpp"

namespace echomap::mapping {

/// A number for each cell of a rectangle, all of them held.
class CellField {
 public:
  CellField(const CellBounds& bounds, double resolution_m)
      : bounds_(bounds),
        resolution_m_(resolution_m),
        values_(static_cast<std::size_t>(bounds.columns()) *
                static_cast<std::size_t>(bounds.rows())) {}

  const CellBounds& bounds() const { return bounds_; }
  double resolution_m() const { return resolution_m_; }
  std::size_t size() const { return values_.size(); }
  void clear() { std::fill(values_.begin(), values_.end(), 0.0F); }

  geometry::CellIndex cell_at(const Eigen::Vector2d& point_m) const {
    return {rounded_down(point_m.x() / resolution_m_), rounded_down(point_m.y() / resolution_m_)};
  }
  Eigen::Vector2d center_m(geometry::CellIndex cell) const {
    return resolution_m_ * Eigen::Vector2d(cell.x + 0.5, cell.y + 0.5);
  }
  bool holds(geometry::CellIndex cell) const { return bounds_.holds(cell); }
  /// Where the cell, which the field holds, has its value.
  std::size_t index(geometry::CellIndex cell) const { return bounds_.index(cell); }
  /// The cell whose value has that index.
  geometry::CellIndex cell(std::size_t index) const {
    const auto columns = static_cast<std::size_t>(bounds_.columns());
    return {bounds_.min.x + static_cast<std::int32_t>(index % columns),
            bounds_.min.y + static_cast<std::int32_t>(index / columns)};
  }
  float& operator[](std::size_t index) { return values_[index]; }
  float operator[](std::size_t index) const { return values_[index]; }

 private:
  /// std::floor is a call where the processor need not have SSE 4.1.
  static std::int32_t rounded_down(double value) {
    const auto towards_zero = static_cast<std::int32_t>(value);
    return towards_zero - (value < towards_zero ? 1 : 0);
  }

  CellBounds bounds_;
  double resolution_m_;
  std::vector<float> values_;
};

}  // namespace echomap::mapping
