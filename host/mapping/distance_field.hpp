// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "host/mapping/raster_map.hpp"

namespace echomap::mapping {

/// How far each cell of a raster map is from the nearest occupied one, centre to centre: the exact
/// Euclidean distance transform, columns first and then the lower envelope of parabolas in each row
/// (Felzenszwalb and Huttenlocher 2012). Unknown cells are no obstacles.
class DistanceField {
 public:
  /// Distances above `max_m` count as that; the smaller it is, the less an update costs. Throws
  /// std::invalid_argument for one that is not above 0 and for a map of more than 2^14 cells along
  /// an edge.
  DistanceField(const RasterMap& map, double max_m);

  /// Makes the field right again after cells of `map` changed, all of them within `changed`, which
  /// is cut to the map. `map` has the size that the field was made for.
  void update(const RasterMap& map, const CellBounds& changed);

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  double resolution_m() const { return resolution_m_; }
  const Eigen::Vector2d& origin_m() const { return origin_m_; }
  /// In cells, not metres; `cell` must be inside.
  float distance_cells(geometry::CellIndex cell) const { return row(cell.y)[cell.x]; }
  const float* row(int y) const {
    return &cells_[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_)];
  }

 private:
  CellBounds cut(const CellBounds& bounds, std::int32_t margin) const;
  void find_heights(const RasterMap& map, const CellBounds& sources, const CellBounds& targets);
  void find_distances(const CellBounds& sources, const CellBounds& targets);
  void find_near_distances(const CellBounds& sources, const CellBounds& targets);
  float* target_row(std::int32_t y, const CellBounds& targets) {
    return &cells_[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) +
                   static_cast<std::size_t>(targets.min.x)];
  }

  int columns_;
  int rows_;
  double resolution_m_;
  Eigen::Vector2d origin_m_;
  float max_cells_;
  std::int32_t reach_cells_;
  std::vector<float> cells_;
  /// Of the window being worked on: cells to the nearest occupied one of the same column.
  std::vector<std::uint16_t> heights_;
};

}  // namespace echomap::mapping
