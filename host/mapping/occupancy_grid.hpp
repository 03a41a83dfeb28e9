// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "host/geometry/cell_index.hpp"

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
};

/// Size and thresholds of an OccupancyGrid.
struct OccupancyGridParams {
  /// Edge of a cell, metres. 5 cm is the habit of ROS maps and close to the sonar's noise of 3 cm.
  double resolution_m = 0.05;
  /// Log-odds stay within +- this many hundredths, so that a cell can change its mind (p = 0.993).
  std::int16_t clamp_centilogits = 500;
  /// A cell is free at or below, and occupied at or above, these probabilities: the values of
  /// ROS map_saver and map_server.
  double free_threshold = 0.196;
  double occupied_threshold = 0.65;
};

/// Occupancy of square cells in the map frame, as log-odds in hundredths ("centilogits"; Moravec
/// and Elfes 1985). It grows in tiles towards wherever evidence falls, and a cell that no evidence
/// has touched is unknown, not even odds.
class OccupancyGrid {
 public:
  /// Throws std::invalid_argument for a resolution or thresholds that make no sense.
  explicit OccupancyGrid(const OccupancyGridParams& params = {});

  double resolution_m() const { return params_.resolution_m; }
  geometry::CellIndex cell_at(const Eigen::Vector2d& point_m) const;
  Eigen::Vector2d center_m(geometry::CellIndex cell) const;

  /// Adds evidence: positive speaks for occupied, negative for free, zero touches nothing.
  void add(geometry::CellIndex cell, int centilogits);

  /// Empty where no evidence has ever fallen.
  std::optional<int> centilogits(geometry::CellIndex cell) const;
  /// Probability that the cell is occupied; empty where no evidence has ever fallen.
  std::optional<double> probability(geometry::CellIndex cell) const;
  CellState state(geometry::CellIndex cell) const;

  /// The smallest rectangle around all touched cells; empty while there is none.
  const CellBounds& bounds() const { return bounds_; }

 private:
  static constexpr std::int32_t kTileBits = 5;
  static constexpr std::int32_t kTileSide = 1 << kTileBits;
  static constexpr std::int16_t kUntouched = std::numeric_limits<std::int16_t>::min();
  using Tile = std::array<std::int16_t, std::size_t{kTileSide} * kTileSide>;

  const std::int16_t* find(geometry::CellIndex cell) const;
  std::int16_t& touch(geometry::CellIndex cell);
  void grow_table_to(geometry::CellIndex tile);

  OccupancyGridParams params_;
  int free_centilogits_ = 0;
  int occupied_centilogits_ = 0;
  CellBounds bounds_;
  /// The rectangle of tiles that `tile_table_` covers, row by row; an entry of -1 has no tile yet.
  CellBounds tile_bounds_;
  std::vector<std::int32_t> tile_table_;
  std::vector<Tile> tiles_;
};

/// Area of the cells that `now` holds free and `before` held unknown, in square metres.
double newly_free_area_m2(const OccupancyGrid& before, const OccupancyGrid& now);

}  // namespace echomap::mapping
