// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "host/geometry/cell_index.hpp"
#include "host/mapping/grid_tile.hpp"
#include "host/mapping/tile_index.hpp"

namespace echomap::mapping {

/// What is known of a cell.
enum class CellState : std::uint8_t { kUnknown, kFree, kOccupied };

/// A rectangle of cells, both corners included; without any cell at first.
struct CellBounds {
  geometry::CellIndex min{0, 0};
  geometry::CellIndex max{-1, -1};

  bool empty() const { return max.x < min.x; }
  std::int32_t columns() const { return max.x - min.x + 1; }
  std::int32_t rows() const { return max.y - min.y + 1; }
  bool holds(geometry::CellIndex cell) const {
    return cell.x >= min.x && cell.x <= max.x && cell.y >= min.y && cell.y <= max.y;
  }
  /// Of a cell that it holds, counted row by row upwards.
  std::size_t index(geometry::CellIndex cell) const {
    return static_cast<std::size_t>(cell.y - min.y) * static_cast<std::size_t>(columns()) +
           static_cast<std::size_t>(cell.x - min.x);
  }
  bool operator==(const CellBounds&) const = default;
};

/// The smallest rectangle around two.
CellBounds united(const CellBounds& one, const CellBounds& other);

/// Evidence is kept in whole steps of this many hundredths of log-odds.
constexpr int kStepCentilogits = 5;

/// Size and thresholds of an OccupancyGrid.
struct OccupancyGridParams {
  /// Edge of a cell, metres. 5 cm is the habit of ROS maps and close to the sonar's noise of 3 cm.
  double resolution_m = 0.05;
  /// Log-odds stay within +- this many hundredths, so that a cell can change its mind (p = 0.993).
  /// One step to 127 steps.
  std::int16_t clamp_centilogits = 500;
  /// A cell is free at or below, and occupied at or above, these probabilities: the values of
  /// ROS map_saver and map_server.
  double free_threshold = 0.196;
  double occupied_threshold = 0.65;
};

/// Occupancy of square cells in the map frame, as log-odds (Moravec and Elfes 1985) in one byte a
/// cell. It grows in tiles of 64 x 64 cells towards wherever evidence falls; ground without any
/// costs nothing. A cell that no evidence has touched is unknown, not even odds.
class OccupancyGrid {
 public:
  /// Throws std::invalid_argument for an invalid resolution, clamp or thresholds.
  explicit OccupancyGrid(const OccupancyGridParams& params = {});

  double resolution_m() const { return params_.resolution_m; }
  /// Points beyond 2^30 cells fall into the last cell that is counted.
  geometry::CellIndex cell_at(const Eigen::Vector2d& point_m) const;
  Eigen::Vector2d center_m(geometry::CellIndex cell) const;

  /// Adds evidence in hundredths of log-odds, rounded to whole steps: positive speaks for occupied,
  /// negative for free; what rounds to zero touches nothing.
  void add(geometry::CellIndex cell, int centilogits);

  /// Empty where no evidence has ever fallen.
  std::optional<int> centilogits(geometry::CellIndex cell) const;
  /// Probability that the cell is occupied; empty where no evidence has ever fallen.
  std::optional<double> probability(geometry::CellIndex cell) const;
  CellState state(geometry::CellIndex cell) const;

  /// The smallest rectangle around all touched cells; empty while there is none.
  const CellBounds& bounds() const { return bounds_; }

  /// Moves on with every insertion of evidence.
  std::uint64_t revision() const { return revision_; }
  /// The tiles that got evidence after `revision`; tile (i, j) holds the cells from (64 i, 64 j).
  std::vector<geometry::CellIndex> tiles_changed_since(std::uint64_t revision) const;
  /// All memory that the grid holds, tiles and tables.
  std::size_t memory_bytes() const;

  /// For kernels that write many cells at once: begin, write tiles by after_evidence, and end with
  /// the rectangle around the cells that evidence has fallen on.
  void begin_insertion() { ++revision_; }
  void end_insertion(const CellBounds& touched);
  /// The tile to write evidence into; made if it was not there, and changed from now on.
  GridTile& writable_tile(geometry::CellIndex tile);
  /// The tile to read; null where none is.
  const GridTile* find_tile(geometry::CellIndex tile) const;
  /// Evidence in whole steps as the kernels add it; more than the whole range counts as that.
  StepPair steps(int centilogits) const;
  EvidenceLimits limits() const { return limits_; }

 private:
  struct TileRecord {
    geometry::CellIndex tile;
    std::uint64_t changed = 0;
  };

  std::uint8_t byte_at(geometry::CellIndex cell) const;

  OccupancyGridParams params_;
  int free_centilogits_ = 0;
  int occupied_centilogits_ = 0;
  EvidenceLimits limits_;
  CellBounds bounds_;
  std::uint64_t revision_ = 0;
  TileIndex index_;
  std::vector<TileRecord> records_;
  std::deque<GridTile> tiles_;  ///< In the order of `records_`; a tile never moves.
};

/// Area of the cells that `now` holds free and `before` held unknown, in square metres.
double newly_free_area_m2(const OccupancyGrid& before, const OccupancyGrid& now);

}  // namespace echomap::mapping
