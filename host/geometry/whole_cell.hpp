// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

namespace echomap::geometry {

/// The column or row that a coordinate, counted in cells, falls into. What is beyond 2^30 cells
/// falls into the last one that is counted, so that no point is too far to have a cell.
inline std::int32_t whole_cell(double in_cells) {
  constexpr double kFarthest = 1 << 30;
  const double counted = std::clamp(in_cells, -kFarthest, kFarthest);
  // std::floor is a call where the processor need not have SSE 4.1.
  const auto towards_zero = static_cast<std::int32_t>(counted);
  return towards_zero - (counted < towards_zero ? 1 : 0);
}

}  // namespace echomap::geometry
