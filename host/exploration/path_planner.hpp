// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "host/exploration/cost_grid.hpp"

namespace echomap::exploration {

/// A way and what it costs.
struct PlannedPath {
  /// From the middle of the first cell to that of the last, the corners between.
  std::vector<Eigen::Vector2d> points_m;
  /// In metres of open floor.
  double cost_m = 0.0;
};

/// What the straight line between the middles of two cells costs, in metres of open floor; empty
/// where it meets a closed cell.
std::optional<double> line_cost_m(const CostGrid& grid,
                                  geometry::CellIndex from,
                                  geometry::CellIndex to);

/// Finds ways of any angle over a cost grid: theta* (Nash et al. 2007), that is A* in which the
/// parent of a cell is any cell in sight of it. A line to the parent is priced by the cells under
/// it, and is taken where it is no dearer than the step from the neighbour. Holds its memory from
/// one search to the next; makes none per cell.
class PathPlanner {
 public:
  /// Empty where no way leads there.
  std::optional<PlannedPath> find(const CostGrid& grid,
                                  geometry::CellIndex from,
                                  geometry::CellIndex to);

 private:
  struct Node {
    float cost_m;
    std::uint32_t parent;
    bool closed;
  };
  /// Estimate of the whole way through the cell, and the cell.
  using Entry = std::pair<float, std::uint32_t>;

  void reset(std::size_t cells);
  void expand(const CostGrid& grid, std::uint32_t at, geometry::CellIndex goal);
  void push(float estimate_m, std::uint32_t at);
  std::uint32_t pop();
  PlannedPath path_to(const CostGrid& grid, std::uint32_t goal) const;

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> touched_;
  std::vector<Entry> heap_;  ///< A binary heap, the cheapest first.
};

}  // namespace echomap::exploration
