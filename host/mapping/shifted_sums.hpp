// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/geometry/cell_index.hpp"

namespace echomap::mapping {

/// Shifts of every second cell each way: `first`, `columns` of them to the right, `rows` upwards.
struct EvenShifts {
  geometry::CellIndex first;
  int columns = 0;
  int rows = 0;
};

/// A number for each cell of a map, to be summed over a few cells that are shifted all over it.
class ShiftedSums {
 public:
  /// `numbers` row by row, with `columns` in each.
  ShiftedSums(const std::vector<float>& numbers, int columns);

  /// The sum over the cells for each shift, row by row; cells outside of the map count nothing.
  std::vector<float> over(const std::vector<geometry::CellIndex>& cells,
                          const EvenShifts& shifts) const;

 private:
  int rows_;
  int half_columns_;
  /// The numbers of even columns and those of odd ones, so that every second one is the next.
  std::array<std::vector<float>, 2> halves_;
};

}  // namespace echomap::mapping
