// SPDX-License-Identifier: MIT
#include "host/localization/floor_lattice.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace echomap::localization {

Particles floor_lattice(const mapping::RasterMap& map, double spacing_m, double spacing_rad) {
  const auto stride =
      static_cast<std::int32_t>(std::max(1L, std::lround(spacing_m / map.resolution_m())));
  const auto headings = std::max(1L, std::lround(2.0 * std::numbers::pi / spacing_rad));
  std::vector<geometry::CellIndex> cells;
  for (std::int32_t y = stride / 2; y < map.rows(); y += stride) {
    for (std::int32_t x = stride / 2; x < map.columns(); x += stride) {
      if (map.state({x, y}) == mapping::CellState::kFree) {
        cells.push_back({x, y});
      }
    }
  }
  Particles lattice;
  lattice.resize(cells.size() * static_cast<std::size_t>(headings));
  std::size_t i = 0;
  for (const geometry::CellIndex cell : cells) {
    const Eigen::Vector2d middle_m = map.center_m(cell);
    for (long heading = 0; heading < headings; ++heading, ++i) {
      const double heading_rad =
          2.0 * std::numbers::pi * static_cast<double>(heading) / static_cast<double>(headings);
      lattice.set_pose(i, {middle_m.x(), middle_m.y(), heading_rad});
    }
  }
  return lattice;
}

}  // namespace echomap::localization
