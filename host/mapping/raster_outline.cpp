// SPDX-License-Identifier: MIT
#include "host/mapping/raster_outline.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace echomap::mapping {
namespace {

using geometry::CellIndex;

/// East, north, west, south: each a quarter turn to the left of the one before.
constexpr std::array<CellIndex, 4> kSteps{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

CellIndex moved(CellIndex cell, CellIndex step) { return {cell.x + step.x, cell.y + step.y}; }

/// Some cells of a rectangle.
class CellSet {
 public:
  CellSet(int columns, int rows)
      : columns_(columns),
        rows_(rows),
        held_(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), false) {}

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  bool holds(CellIndex cell) const {
    return cell.x >= 0 && cell.x < columns_ && cell.y >= 0 && cell.y < rows_ &&
           held_[index_of(cell)];
  }
  void set(CellIndex cell, bool held) { held_[index_of(cell)] = held; }

 private:
  std::size_t index_of(CellIndex cell) const {
    return static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(cell.x);
  }

  int columns_;
  int rows_;
  std::vector<bool> held_;
};

CellSet free_cells(const RasterMap& map) {
  CellSet cells(map.columns(), map.rows());
  for (int y = 0; y < map.rows(); ++y) {
    for (int x = 0; x < map.columns(); ++x) {
      cells.set({x, y}, map.state({x, y}) == CellState::kFree);
    }
  }
  return cells;
}

/// Takes the piece that `seed` belongs to out of `cells`.
std::vector<CellIndex> take_piece(CellSet& cells, CellIndex seed) {
  std::vector<CellIndex> piece{seed};
  cells.set(seed, false);
  for (std::size_t i = 0; i < piece.size(); ++i) {
    for (const CellIndex step : kSteps) {
      const CellIndex next = moved(piece[i], step);
      if (cells.holds(next)) {
        cells.set(next, false);
        piece.push_back(next);
      }
    }
  }
  return piece;
}

CellSet largest_piece(CellSet cells) {
  CellSet largest(cells.columns(), cells.rows());
  std::vector<CellIndex> best;
  for (int y = 0; y < cells.rows(); ++y) {
    for (int x = 0; x < cells.columns(); ++x) {
      if (!cells.holds({x, y})) {
        continue;
      }
      auto piece = take_piece(cells, {x, y});
      if (piece.size() > best.size()) {
        best = std::move(piece);
      }
    }
  }
  for (const CellIndex cell : best) {
    largest.set(cell, true);
  }
  return largest;
}

/// Gives up one of any two cells that meet in a corner alone; false where there are none.
bool cut_pinches(CellSet& cells) {
  bool any = false;
  for (int y = 0; y + 1 < cells.rows(); ++y) {
    for (int x = 0; x + 1 < cells.columns(); ++x) {
      const bool low_left = cells.holds({x, y});
      const bool low_right = cells.holds({x + 1, y});
      if (low_left != low_right && low_left == cells.holds({x + 1, y + 1}) &&
          low_right == cells.holds({x, y + 1})) {
        cells.set(low_left ? CellIndex{x, y} : CellIndex{x + 1, y}, false);
        any = true;
      }
    }
  }
  return any;
}

/// Walks borders with the cells to the left, from lattice point to lattice point.
class BorderWalk {
 public:
  explicit BorderWalk(const CellSet& cells)
      : cells_(cells), walked_(cells.columns() + 1, cells.rows() + 1) {}

  /// Whether a border goes east from here that has not been walked.
  bool begins_at(CellIndex point) const { return is_border(point, 0) && !walked_.holds(point); }

  /// The corners of the ring that goes east from `start`.
  std::vector<CellIndex> ring_from(CellIndex start) {
    std::vector<CellIndex> corners;
    CellIndex point = start;
    std::size_t heading = 0;
    do {
      if (heading == 0) {
        walked_.set(point, true);
      }
      point = moved(point, kSteps[heading]);
      const std::size_t next = heading_after(point, heading);
      if (next != heading) {
        corners.push_back(point);
      }
      heading = next;
    } while (point != start || heading != 0);
    return corners;
  }

 private:
  /// Whether the edge that leaves `point` has a cell on its left and none on its right.
  bool is_border(CellIndex point, std::size_t heading) const {
    constexpr std::array<CellIndex, 4> kLeft{{{0, 0}, {-1, 0}, {-1, -1}, {0, -1}}};
    return cells_.holds(moved(point, kLeft[heading])) &&
           !cells_.holds(moved(point, kLeft[(heading + 3) % 4]));
  }

  std::size_t heading_after(CellIndex point, std::size_t heading) const {
    for (const std::size_t turn : {1U, 3U}) {
      if (is_border(point, (heading + turn) % 4)) {
        return (heading + turn) % 4;
      }
    }
    return heading;
  }

  const CellSet& cells_;
  CellSet walked_;
};

geometry::Polygon in_metres(const std::vector<CellIndex>& corners, const RasterMap& map) {
  geometry::Polygon polygon;
  for (const CellIndex corner : corners) {
    polygon.emplace_back(map.origin_m() + map.resolution_m() * Eigen::Vector2d(corner.x, corner.y));
  }
  return polygon;
}

}  // namespace

std::vector<geometry::Polygon> free_floor_rings(const RasterMap& map) {
  CellSet floor = largest_piece(free_cells(map));
  while (cut_pinches(floor)) {
    floor = largest_piece(floor);
  }
  std::vector<geometry::Polygon> rings;
  BorderWalk walk(floor);
  for (int y = 0; y <= map.rows(); ++y) {
    for (int x = 0; x <= map.columns(); ++x) {
      if (walk.begins_at({x, y})) {
        rings.push_back(in_metres(walk.ring_from({x, y}), map));
      }
    }
  }
  const auto is_outline = [](const auto& ring) { return geometry::signed_area_m2(ring) > 0.0; };
  std::stable_partition(rings.begin(), rings.end(), is_outline);
  return rings;
}

}  // namespace echomap::mapping
