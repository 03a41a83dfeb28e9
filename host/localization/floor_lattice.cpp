// SPDX-License-Identifier: MIT
#include "host/localization/floor_lattice.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

namespace echomap::localization {

namespace {

/// The free cell nearest to the middle of the block that begins there.
std::optional<geometry::CellIndex> standing_place(const mapping::RasterMap& map,
                                                  geometry::CellIndex first,
                                                  std::int32_t stride) {
  std::optional<geometry::CellIndex> best;
  std::int32_t least = std::numeric_limits<std::int32_t>::max();
  for (std::int32_t y = first.y; y < std::min(first.y + stride, map.rows()); ++y) {
    for (std::int32_t x = first.x; x < std::min(first.x + stride, map.columns()); ++x) {
      const std::int32_t off_x = x - first.x - stride / 2;
      const std::int32_t off_y = y - first.y - stride / 2;
      const std::int32_t off = off_x * off_x + off_y * off_y;
      if (off < least && map.state({x, y}) == mapping::CellState::kFree) {
        least = off;
        best = {x, y};
      }
    }
  }
  return best;
}

}  // namespace

Particles floor_lattice(const mapping::RasterMap& map, double spacing_m, double spacing_rad) {
  const auto stride =
      static_cast<std::int32_t>(std::max(1L, std::lround(spacing_m / map.resolution_m())));
  const auto headings = std::max(1L, std::lround(2.0 * std::numbers::pi / spacing_rad));
  std::vector<geometry::CellIndex> cells;
  for (std::int32_t y = 0; y < map.rows(); y += stride) {
    for (std::int32_t x = 0; x < map.columns(); x += stride) {
      if (const auto cell = standing_place(map, {x, y}, stride)) {
        cells.push_back(*cell);
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
