// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>

#include "host/geometry/cell_index.hpp"

namespace echomap::mapping {

/// Of the grids here, the first with its corner in the origin.
inline constexpr double kCellM = 0.05;

inline geometry::CellIndex cell_around(double x_m, double y_m) {
  return {static_cast<std::int32_t>(std::floor(x_m / kCellM)),
          static_cast<std::int32_t>(std::floor(y_m / kCellM))};
}

}  // namespace echomap::mapping
