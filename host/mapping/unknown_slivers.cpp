// SPDX-License-Identifier: MIT
#include "host/mapping/unknown_slivers.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace echomap::mapping {
namespace {

/// The squares of cells that touch a map, beyond whose edges all is unknown.
class Squares {
 public:
  Squares(const RasterMap& map, int width) : width_(width), columns_(map.columns() + width - 1) {
    for (int y = 1 - width; y < map.rows(); ++y) {
      for (int x = 1 - width; x < map.columns(); ++x) {
        bool has_floor = false;
        for (int i = 0; i < width * width && !has_floor; ++i) {
          has_floor = map.state({x + i % width, y + i / width}) == CellState::kFree;
        }
        has_floor_.push_back(has_floor);
      }
    }
  }

  /// Whether a cell of the map is in any square without floor.
  bool any_without_floor(int x, int y) const {
    for (int i = 0; i < width_ * width_; ++i) {
      // Counted from the first square, which ends in cell (0, 0).
      const int left = x + width_ - 1 - i % width_;
      const int low = y + width_ - 1 - i / width_;
      if (!has_floor_[static_cast<std::size_t>(low) * static_cast<std::size_t>(columns_) +
                      static_cast<std::size_t>(left)]) {
        return true;
      }
    }
    return false;
  }

 private:
  int width_;
  int columns_;
  std::vector<bool> has_floor_;  ///< By lower left cell, row by row.
};

}  // namespace

RasterMap without_unknown_slivers(const RasterMap& map, double width_m) {
  const int width_cells = std::max(1, static_cast<int>(std::lround(width_m / map.resolution_m())));
  const Squares squares(map, width_cells);
  RasterMap filled = map;
  for (int y = 0; y < map.rows(); ++y) {
    for (int x = 0; x < map.columns(); ++x) {
      if (map.state({x, y}) == CellState::kUnknown && !squares.any_without_floor(x, y)) {
        filled.set({x, y}, CellState::kFree);
      }
    }
  }
  return filled;
}

}  // namespace echomap::mapping
