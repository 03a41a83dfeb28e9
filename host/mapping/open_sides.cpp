// SPDX-License-Identifier: MIT
#include "host/mapping/open_sides.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "host/geometry/segment.hpp"

namespace echomap::mapping {
namespace {

using geometry::Segment;

constexpr double kWallReachM = 0.05;
/// Cells to each side of that of a point, along x and y.
constexpr int kCellReach = 2;

bool has_occupied_cell(const RasterMap& map, const Eigen::Vector2d& point_m) {
  const geometry::CellIndex cell = map.cell_at(point_m);
  for (int y = -kCellReach; y <= kCellReach; ++y) {
    for (int x = -kCellReach; x <= kCellReach; ++x) {
      if (map.state({cell.x + x, cell.y + y}) == CellState::kOccupied) {
        return true;
      }
    }
  }
  return false;
}

bool has_wall(const std::vector<Segment>& walls, const Eigen::Vector2d& point_m) {
  return std::any_of(walls.begin(), walls.end(), [&](const Segment& wall) {
    return geometry::distance_m(wall, point_m) <= kWallReachM;
  });
}

}  // namespace

std::vector<bool> open_sides(const geometry::Polygon& outline_m,
                             const RasterMap& map,
                             const SonarFeatures& features) {
  std::vector<bool> is_open;
  for (std::size_t i = 0; i < outline_m.size(); ++i) {
    const Segment side = geometry::side(outline_m, i);
    const int steps = std::max(1, static_cast<int>(side.length_m() / map.resolution_m()));
    int walled = 0;
    for (int step = 0; step < steps; ++step) {
      const Eigen::Vector2d point_m =
          side.from_m + (step + 0.5) / steps * (side.to_m - side.from_m);
      walled += has_wall(features.walls, point_m) || has_occupied_cell(map, point_m) ? 1 : 0;
    }
    is_open.push_back(2 * walled < steps);
  }
  return is_open;
}

}  // namespace echomap::mapping
