// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host/mapping/tile_kernel.hpp"

namespace echomap::mapping {

/// A cell has so many lattice units along each edge. Ends of rays have odd coordinates, so that
/// none lies on the border of a cell.
constexpr int kLatticeBits = 8;

/// A point of a RayMask's window, in lattice units from its lower left corner.
struct LatticePoint {
  std::int32_t x = 0;
  std::int32_t y = 0;
};

/// Seen from a sensor, counter-clockwise; an axis belongs to the quadrant where neither coordinate
/// is negative, or only x.
enum class Quadrant : std::uint8_t { kRightUp, kLeftUp, kLeftDown, kRightDown };

/// The most cells that a window may have along an edge.
constexpr std::int32_t kMaxWindowCells = 4096;

/// A window of tiles with one bit a cell: crossed by a ray or not.
///
/// A ray's cells in one row are neighbours, so a ray that is flatter than 45 degrees takes one run
/// of bits a row; a steeper one does the same by columns in a second mask, which is turned over in
/// blocks of 64 x 64 in the end. The cells are those of Amanatides and Woo (1987), in whole numbers
/// and so without rounding; a ray through the corner of four cells is taken to lie a hair towards
/// larger coordinates of the axis along which it is longer (x, where both are as long).
class RayMask {
 public:
  /// An empty window of so many tiles.
  void reset(std::int32_t tile_columns, std::int32_t tile_rows);
  std::int32_t tile_columns() const { return tile_columns_; }
  std::int32_t tile_rows() const { return tile_rows_; }

  /// Marks the cells on ways from one point; both ends must be inside and have odd coordinates.
  /// Those that a ray only meets within its covered share of the way, from the beginning on, may be
  /// left out. There is a share for each way.
  void add_rays(LatticePoint from,
                std::span<const LatticePoint> directions,
                std::span<const double> covered_shares);
  /// Marks the cells whose centres are within `radius` lattice units of a point and in a quadrant
  /// around it, all of which must be inside.
  void add_quadrant(LatticePoint center, Quadrant quadrant, double radius);
  /// The marked cells of a tile of the window.
  TileBits tile(std::int32_t column, std::int32_t row) const;

 private:
  std::int32_t tile_columns_ = 0;
  std::int32_t tile_rows_ = 0;
  std::vector<std::uint64_t> flat_;   ///< Row by row, with a word to spare at the end.
  std::vector<std::uint64_t> steep_;  ///< Column by column, likewise.
};

}  // namespace echomap::mapping
