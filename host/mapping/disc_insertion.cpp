// SPDX-License-Identifier: MIT
#include "host/mapping/disc_insertion.hpp"

#include <cmath>

namespace echomap::mapping {

void insert_disc(const Eigen::Vector2d& middle_m,
                 double radius_m,
                 int centilogits,
                 OccupancyGrid& grid) {
  if (!middle_m.allFinite() || !std::isfinite(radius_m)) {
    return;
  }
  const Eigen::Vector2d half_m = Eigen::Vector2d::Constant(0.5 * grid.resolution_m());
  const geometry::CellIndex low = grid.cell_at(middle_m.array() - radius_m);
  const geometry::CellIndex high = grid.cell_at(middle_m.array() + radius_m);
  for (geometry::CellIndex cell = low; cell.y <= high.y; ++cell.y) {
    for (cell.x = low.x; cell.x <= high.x; ++cell.x) {
      const Eigen::Vector2d off_m = (grid.center_m(cell) - middle_m).cwiseAbs() + half_m;
      if (off_m.norm() <= radius_m) {
        grid.add(cell, centilogits);
      }
    }
  }
}

}  // namespace echomap::mapping
