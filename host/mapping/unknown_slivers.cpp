// SPDX-License-Identifier: MIT
#include "host/mapping/unknown_slivers.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace echomap::mapping {
namespace {

/// A mark for each cell of a rectangle, row by row.
struct CellMarks {
  int columns = 0;
  int rows = 0;
  std::vector<bool> marks;

  CellMarks(int width, int height)
      : columns(width), rows(height), marks(std::size_t(width) * std::size_t(height)) {}
  std::size_t index(int x, int y) const {
    return std::size_t(y) * std::size_t(columns) + std::size_t(x);
  }
};

/// Of each square of `width` x `width` cells that touches the rectangle, whether a marked cell is
/// in it. A square is at its upper right cell, so that the cost does not depend on the width.
CellMarks squares_with_mark(const CellMarks& cells, int width) {
  CellMarks in_row(cells.columns + width - 1, cells.rows);
  for (int y = 0; y < cells.rows; ++y) {
    int count = 0;
    for (int x = 0; x < in_row.columns; ++x) {
      count += x < cells.columns && cells.marks[cells.index(x, y)] ? 1 : 0;
      count -= x >= width && cells.marks[cells.index(x - width, y)] ? 1 : 0;
      in_row.marks[in_row.index(x, y)] = count > 0;
    }
  }
  CellMarks squares(in_row.columns, cells.rows + width - 1);
  std::vector<int> counts(std::size_t(squares.columns));
  for (int y = 0; y < squares.rows; ++y) {
    for (int x = 0; x < squares.columns; ++x) {
      int& count = counts[std::size_t(x)];
      count += y < in_row.rows && in_row.marks[in_row.index(x, y)] ? 1 : 0;
      count -= y >= width && in_row.marks[in_row.index(x, y - width)] ? 1 : 0;
      squares.marks[squares.index(x, y)] = count > 0;
    }
  }
  return squares;
}

}  // namespace

RasterMap without_unknown_slivers(const RasterMap& map, double width_m) {
  const int width = std::max(1, static_cast<int>(std::lround(width_m / map.resolution_m())));
  CellMarks floor(map.columns(), map.rows());
  for (int y = 0; y < map.rows(); ++y) {
    for (int x = 0; x < map.columns(); ++x) {
      floor.marks[floor.index(x, y)] = map.state({x, y}) == CellState::kFree;
    }
  }
  CellMarks without_floor = squares_with_mark(floor, width);
  without_floor.marks.flip();
  // The squares that a cell is in end in it, and in those beside and above.
  const CellMarks in_any = squares_with_mark(without_floor, width);
  RasterMap filled = map;
  for (int y = 0; y < map.rows(); ++y) {
    for (int x = 0; x < map.columns(); ++x) {
      if (map.state({x, y}) == CellState::kUnknown &&
          !in_any.marks[in_any.index(x + width - 1, y + width - 1)]) {
        filled.set({x, y}, CellState::kFree);
      }
    }
  }
  return filled;
}

}  // namespace echomap::mapping
