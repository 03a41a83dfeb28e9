// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstdint>

namespace echomap::geometry {

/// Names one cell of a grid; never a length. Cell (i, j) of a grid with edge length r covers
/// [i r, (i + 1) r) x [j r, (j + 1) r) of the grid's frame, so x is the column and y the row,
/// upwards.
struct CellIndex {
  std::int32_t x = 0;
  std::int32_t y = 0;

  auto operator<=>(const CellIndex&) const = default;
};

}  // namespace echomap::geometry
