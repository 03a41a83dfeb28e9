// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace echomap::geometry {

/// The column or row that a coordinate, counted in cells, falls into. What is beyond 2^30 cells
/// falls into the last one that is counted, so that no point is too far to have a cell.
inline std::int32_t whole_cell(double in_cells) {
  constexpr double kFarthest = 1 << 30;
  return static_cast<std::int32_t>(std::floor(std::clamp(in_cells, -kFarthest, kFarthest)));
}

}  // namespace echomap::geometry
