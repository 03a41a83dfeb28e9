// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "host/mapping/occupancy_grid.hpp"

namespace echomap::mapping {

/// The farthest that a sector reaches, in cells.
constexpr std::int32_t kMostSectorCells = 2000;
/// From row to row the side of a wedge moves by whole times 1 / 512 of a column: it is off by at
/// most 0.06 degrees, and the columns in reach fit 31 bits.
constexpr int kSlopeBits = 9;

/// A half plane with the apex on its border.
struct Side {
  Side() = default;
  /// What is to the right of someone who looks from the apex along `ray`, or else to the left.
  Side(const Eigen::Vector2d& ray, bool is_right);

  std::int32_t slope = 0;      ///< How far the border moves from row to row.
  bool is_from_border = true;  ///< Columns from the border on, or else up to it.
};

/// A wedge less than half a turn wide, between two rays from the apex.
struct Wedge {
  /// `half_opening` as its cosine and sine, `axis` a unit vector.
  Wedge(const Eigen::Vector2d& axis, const Eigen::Vector2d& half_opening);

  Eigen::Vector2d left_ray;
  Eigen::Vector2d right_ray;
  Side right_of_left;
  Side left_of_right;
};

/// Cells by the square of their distance from the apex, in cells: more than `hole`, at most `rim`.
struct Ring {
  std::int32_t hole = -1;
  std::int32_t rim = -1;
};

/// Rows or columns from the first to the last.
struct Stretch {
  std::int32_t first = 0;
  std::int32_t last = -1;
};

/// Columns `from` to `to` of a row, and of those above it; `to` is not included and never before
/// `from`. Both negated.
struct RowColumns {
  const std::int16_t* minus_from;
  const std::int16_t* minus_to;
};

/// The columns of each row that wedges around one axis share with a ring, all as seen from the
/// apex cell.
class SectorRows {
 public:
  /// `reach_cells` at most kMostSectorCells.
  SectorRows(std::size_t wedges, std::int32_t reach_cells);

  /// `wedges` from the widest to the narrowest; the ring must have cells.
  void lay_out(std::span<const Wedge> wedges, const Ring& ring);

  /// The smallest rectangle around all cells.
  const CellBounds& bounds() const { return bounds_; }
  /// The rows with cells in some columns.
  Stretch rows_in(const Stretch& columns) const;

  /// From row `y`, within the bounds, upwards: the columns of a wedge within the rim, and those of
  /// the hole, which are only there if there is one.
  RowColumns wedge(std::size_t number, std::int32_t y) const { return columns(number, y); }
  RowColumns hole(std::int32_t y) const { return columns(wedges_, y); }
  bool has_hole() const { return has_hole_; }

 private:
  RowColumns columns(std::size_t pair, std::int32_t y) const {
    const std::int16_t* const first = &columns_[2 * pair * stride_];
    return {first + (y - first_row_), first + stride_ + (y - first_row_)};
  }
  /// From the first to the last cell.
  RowColumns cells() const { return columns(has_hole_ ? wedges_ + 1 : 0, first_row_); }

  std::size_t wedges_;
  std::size_t stride_;
  std::int32_t first_row_ = 0;
  std::int32_t row_blocks_ = 0;
  bool has_hole_ = false;
  CellBounds bounds_;
  std::vector<std::int16_t> columns_;  ///< Of each wedge, the hole and the cells.
};

}  // namespace echomap::mapping
