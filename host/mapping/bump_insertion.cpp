// SPDX-License-Identifier: MIT
#include "host/mapping/bump_insertion.hpp"

#include <cmath>
#include <cstdint>
#include <optional>

namespace echomap::mapping {

void insert_bump(const geometry::Pose2& T_map_robot,
                 const geometry::Segment& line_m,
                 const BumpParams& params,
                 OccupancyGrid& grid) {
  constexpr double kStepsPerCell = 4.0;
  const Eigen::Vector2d from_m = T_map_robot * line_m.from_m;
  const Eigen::Vector2d along_m = T_map_robot * line_m.to_m - from_m;
  const auto steps =
      static_cast<std::int64_t>(std::ceil(kStepsPerCell * along_m.norm() / grid.resolution_m()));
  // A straight line never comes back to a cell that it has left.
  std::optional<geometry::CellIndex> last;
  for (std::int64_t step = 0; step <= steps; ++step) {
    const double share = steps > 0 ? static_cast<double>(step) / static_cast<double>(steps) : 0.0;
    const geometry::CellIndex cell = grid.cell_at(from_m + share * along_m);
    if (cell != last) {
      grid.add(cell, params.hit_centilogits);
      last = cell;
    }
  }
}

}  // namespace echomap::mapping
