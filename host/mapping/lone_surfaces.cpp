// SPDX-License-Identifier: MIT
#include "host/mapping/lone_surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "host/geometry/unit_vector.hpp"
#include "host/mapping/visit_cells.hpp"

namespace echomap::mapping {

using geometry::CellIndex;

void LoneSurfaces::set(std::size_t index, std::vector<LoneSurface> surfaces) {
  stops_.resize(std::max(stops_.size(), index + 1));
  if (surfaces == stops_[index]) {
    return;
  }
  for (const LoneSurface& lone : stops_[index]) {
    add(lone, -lone.doubt_centilogits);
  }
  stops_[index] = std::move(surfaces);
  for (const LoneSurface& lone : stops_[index]) {
    add(lone, lone.doubt_centilogits);
  }
}

void LoneSurfaces::resize(std::size_t stops) {
  for (std::size_t i = stops; i < stops_.size(); ++i) {
    set(i, {});
  }
  stops_.resize(stops);
}

void LoneSurfaces::add(const LoneSurface& lone, int doubt_centilogits) {
  const std::vector<CellIndex> cells = cells_behind(lone);
  CellBounds bounds;
  for (const CellIndex cell : cells) {
    bounds = united(bounds, {cell, cell});
  }
  if (!sums_.can_hold(bounds)) {
    return;
  }
  sums_.hold(bounds);
  for (const CellIndex cell : cells) {
    sums_.add(cell, doubt_centilogits);
  }
}

std::vector<CellIndex> LoneSurfaces::cells_behind(const LoneSurface& lone) const {
  const SonarSurface& surface = lone.surface;
  const Eigen::Vector2d normal = geometry::unit_vector(surface.bearing_rad);
  const double half_m =
      std::max(surface.half_length_m, surface.range_m * std::tan(params_.half_angle_rad));
  const Eigen::Vector2d half = half_m * geometry::perpendicular(normal);
  const int rows = 1 + static_cast<int>(2.0 * params_.depth_m / resolution_m_);
  std::vector<CellIndex> cells;
  for (int row = 0; row <= rows; ++row) {
    const double depth_m = params_.depth_m * row / rows;
    const Eigen::Vector2d middle_m = lone.center_m + (surface.range_m + depth_m) * normal;
    visit_along({middle_m - half, middle_m + half}, resolution_m_, [&](CellIndex cell) {
      cells.push_back(cell);
    });
  }
  std::sort(cells.begin(), cells.end(), [](CellIndex a, CellIndex b) {
    return std::pair(a.y, a.x) < std::pair(b.y, b.x);
  });
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return cells;
}

}  // namespace echomap::mapping
