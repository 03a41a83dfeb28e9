// SPDX-License-Identifier: MIT
#include "host/mapping/raster_map.hpp"

#include "host/geometry/parameter_validator.hpp"
#include "host/geometry/whole_cell.hpp"

namespace echomap::mapping {

using geometry::CellIndex;

RasterMap::RasterMap(int columns, int rows, double resolution_m, const Eigen::Vector2d& origin_m)
    : columns_(columns), rows_(rows), resolution_m_(resolution_m), origin_m_(origin_m) {
  geometry::ParameterValidator("raster map")
      .at_least("columns", columns, 1)
      .at_least("rows", rows, 1)
      .positive("resolution_m", resolution_m);
  cells_.assign(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows),
                CellState::kUnknown);
}

bool RasterMap::contains(CellIndex cell) const {
  return cell.x >= 0 && cell.x < columns_ && cell.y >= 0 && cell.y < rows_;
}

CellState RasterMap::state(CellIndex cell) const {
  return contains(cell) ? cells_[index_of(cell)] : CellState::kUnknown;
}

void RasterMap::set(CellIndex cell, CellState state) { cells_[index_of(cell)] = state; }

CellIndex RasterMap::cell_at(const Eigen::Vector2d& point_m) const {
  const Eigen::Vector2d in_cells = (point_m - origin_m_) / resolution_m_;
  return {geometry::whole_cell(in_cells.x()), geometry::whole_cell(in_cells.y())};
}

Eigen::Vector2d RasterMap::center_m(CellIndex cell) const {
  return origin_m_ + resolution_m_ * Eigen::Vector2d(cell.x + 0.5, cell.y + 0.5);
}

std::size_t RasterMap::index_of(CellIndex cell) const {
  return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(columns_) +
         static_cast<std::size_t>(cell.x);
}

RasterMap rasterize(const OccupancyGrid& grid) {
  const CellBounds& bounds = grid.bounds();
  if (bounds.empty()) {
    return {1, 1, grid.resolution_m(), Eigen::Vector2d::Zero()};
  }
  const CellIndex corner{bounds.min.x - 1, bounds.min.y - 1};
  const Eigen::Vector2d origin_m = grid.resolution_m() * Eigen::Vector2d(corner.x, corner.y);
  RasterMap raster(bounds.columns() + 2, bounds.rows() + 2, grid.resolution_m(), origin_m);
  for (int y = 0; y < raster.rows(); ++y) {
    for (int x = 0; x < raster.columns(); ++x) {
      raster.set({x, y}, grid.state({corner.x + x, corner.y + y}));
    }
  }
  return raster;
}

RasterMap with_unknown_occupied(RasterMap map) {
  for (int y = 0; y < map.rows(); ++y) {
    for (int x = 0; x < map.columns(); ++x) {
      if (map.state({x, y}) == CellState::kUnknown) {
        map.set({x, y}, CellState::kOccupied);
      }
    }
  }
  return map;
}

std::vector<Eigen::Vector2d> centers_m(const RasterMap& map, CellState state) {
  std::vector<Eigen::Vector2d> centers_m;
  for (int y = 0; y < map.rows(); ++y) {
    for (int x = 0; x < map.columns(); ++x) {
      if (map.state({x, y}) == state) {
        centers_m.push_back(map.center_m({x, y}));
      }
    }
  }
  return centers_m;
}

RasterMap cut_out(const RasterMap& map, const CellBounds& cells) {
  const Eigen::Vector2d shift_m = map.resolution_m() * Eigen::Vector2d(cells.min.x, cells.min.y);
  RasterMap part(cells.columns(), cells.rows(), map.resolution_m(), map.origin_m() + shift_m);
  for (int y = 0; y < part.rows(); ++y) {
    for (int x = 0; x < part.columns(); ++x) {
      part.set({x, y}, map.state({cells.min.x + x, cells.min.y + y}));
    }
  }
  return part;
}

}  // namespace echomap::mapping
