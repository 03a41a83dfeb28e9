// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "host/geometry/cell_index.hpp"
#include "host/mapping/occupancy_grid.hpp"

namespace echomap::mapping {

/// A rectangular picture of a map: one state per cell, as image formats hold it. Cell (0, 0) is the
/// lower left one; its lower left corner lies at `origin_m` of the map frame, without rotation.
class RasterMap {
 public:
  /// All cells begin unknown. Throws std::invalid_argument for a size below 1 x 1 or a resolution
  /// that is not above zero.
  RasterMap(int columns, int rows, double resolution_m, const Eigen::Vector2d& origin_m);

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  double resolution_m() const { return resolution_m_; }
  const Eigen::Vector2d& origin_m() const { return origin_m_; }

  bool contains(geometry::CellIndex cell) const;
  /// Cells outside the picture are unknown.
  CellState state(geometry::CellIndex cell) const;
  /// The states of a row from left to right; `y` must be inside.
  const CellState* row(int y) const { return &cells_[index_of({0, y})]; }
  /// `cell` must be inside.
  void set(geometry::CellIndex cell, CellState state);

  geometry::CellIndex cell_at(const Eigen::Vector2d& point_m) const;
  Eigen::Vector2d center_m(geometry::CellIndex cell) const;

 private:
  std::size_t index_of(geometry::CellIndex cell) const;

  int columns_;
  int rows_;
  double resolution_m_;
  Eigen::Vector2d origin_m_;
  std::vector<CellState> cells_;
};

/// The grid's touched rectangle with a margin of one unknown cell; of an untouched grid one unknown
/// cell at the origin.
RasterMap rasterize(const OccupancyGrid& grid);

/// With an obstacle in each unknown cell: rays end where the known floor does.
RasterMap with_unknown_occupied(RasterMap map);

/// Centres of the cells that are so, row by row.
std::vector<Eigen::Vector2d> centers_m(const RasterMap& map, CellState state);

/// The part of a map within `cells`, which may reach beyond it into the unknown. Throws
/// std::invalid_argument for no cells.
RasterMap cut_out(const RasterMap& map, const CellBounds& cells);

}  // namespace echomap::mapping
