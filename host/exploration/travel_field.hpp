// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "host/exploration/cost_grid.hpp"

namespace echomap::exploration {

/// What the way from one cell to every other costs, by steps to the eight neighbours: the search of
/// Dijkstra 1959 with the queue of Dial 1969. For the prices of many goals at once; the way to the
/// one that is chosen is PathPlanner's. Holds its memory from one search to the next.
class TravelField {
 public:
  /// Searches from `from`; where that is closed or outside, nothing is reached.
  void search(const CostGrid& grid, geometry::CellIndex from);

  bool reaches(geometry::CellIndex cell) const { return cost_m(cell).has_value(); }
  /// Metres of open floor that cost as much as the way to `cell`; empty where no way leads there.
  std::optional<double> cost_m(geometry::CellIndex cell) const;

 private:
  static constexpr std::uint32_t kUnreached = UINT32_MAX;

  std::int32_t columns_ = 0;
  std::int32_t rows_ = 0;
  double metres_per_unit_ = 0.0;
  std::vector<std::uint32_t> costs_;  ///< With the border of CostGrid.
  std::vector<std::vector<std::uint32_t>> buckets_;
};

}  // namespace echomap::exploration
