// SPDX-License-Identifier: MIT
#include "host/localization/scattered_particles.hpp"

#include <numbers>
#include <vector>

namespace echomap::localization {

namespace {

double unit(std::mt19937& random) { return static_cast<double>(random()) * 0x1p-32; }

std::vector<geometry::CellIndex> free_cells(const mapping::RasterMap& map) {
  std::vector<geometry::CellIndex> cells;
  for (std::int32_t y = 0; y < map.rows(); ++y) {
    for (std::int32_t x = 0; x < map.columns(); ++x) {
      if (map.state({x, y}) == mapping::CellState::kFree) {
        cells.push_back({x, y});
      }
    }
  }
  return cells;
}

}  // namespace

Particles scattered_particles(const mapping::RasterMap& map,
                              std::size_t count,
                              std::mt19937& random) {
  const std::vector<geometry::CellIndex> cells = free_cells(map);
  Particles particles;
  if (cells.empty()) {
    return particles;
  }
  particles.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto cell =
        cells[static_cast<std::size_t>(unit(random) * static_cast<double>(cells.size()))];
    const double x_m = map.center_m(cell).x() + map.resolution_m() * (unit(random) - 0.5);
    const double y_m = map.center_m(cell).y() + map.resolution_m() * (unit(random) - 0.5);
    const double heading_rad = (2.0 * unit(random) - 1.0) * std::numbers::pi;
    particles.set_pose(i, {x_m, y_m, heading_rad});
  }
  return particles;
}

}  // namespace echomap::localization
