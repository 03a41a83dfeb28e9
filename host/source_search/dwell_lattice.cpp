// SPDX-License-Identifier: MIT
#include "host/source_search/dwell_lattice.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <queue>
#include <utility>

#include "host/exploration/path_planner.hpp"

namespace echomap::source_search {

using exploration::CostGrid;
using geometry::CellIndex;

namespace {

/// Places are neighbours up to so many spacings apart.
constexpr double kNeighbourSpacings = 2.3;

/// The open cell of a square that is nearest to its middle.
std::optional<CellIndex> open_cell(const CostGrid& costs, CellIndex low, int side) {
  std::optional<CellIndex> best;
  int best_off = 0;
  for (int i = 0; i < side * side; ++i) {
    const CellIndex cell{low.x + i % side, low.y + i / side};
    const int off_x = 2 * (i % side) - side + 1;
    const int off_y = 2 * (i / side) - side + 1;
    const int off = off_x * off_x + off_y * off_y;
    if (costs.is_open(cell) && (!best || off < best_off)) {
      best = cell;
      best_off = off;
    }
  }
  return best;
}

}  // namespace

DwellLattice::DwellLattice(const CostGrid& costs, double spacing_m) : spacing_m_(spacing_m) {
  const int side = std::max(1, static_cast<int>(std::lround(spacing_m / costs.resolution_m())));
  for (int y = 0; y < costs.rows(); y += side) {
    for (int x = 0; x < costs.columns(); x += side) {
      if (const auto cell = open_cell(costs, {x, y}, side)) {
        places_m_.push_back(costs.center_m(*cell));
      }
    }
  }
  edges_.resize(places_m_.size());
  for (std::size_t i = 0; i < places_m_.size(); ++i) {
    for (std::size_t j = i + 1; j < places_m_.size(); ++j) {
      const double length_m = (places_m_[i] - places_m_[j]).norm();
      if (length_m < kNeighbourSpacings * spacing_m_ &&
          exploration::line_cost_m(
              costs, costs.cell_at(places_m_[i]), costs.cell_at(places_m_[j]))) {
        edges_[i].push_back({static_cast<std::uint32_t>(j), static_cast<float>(length_m)});
        edges_[j].push_back({static_cast<std::uint32_t>(i), static_cast<float>(length_m)});
      }
    }
  }
}

DwellLattice::Tree DwellLattice::tree_from(const CostGrid& costs,
                                           const Eigen::Vector2d& from_m) const {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Tree tree{std::vector<double>(places_m_.size(), kFar),
            std::vector<std::int32_t>(places_m_.size(), -1),
            {}};
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (std::size_t i = 0; i < places_m_.size(); ++i) {
    const double length_m = (places_m_[i] - from_m).norm();
    if (length_m < kNeighbourSpacings * spacing_m_ &&
        exploration::line_cost_m(costs, costs.cell_at(from_m), costs.cell_at(places_m_[i]))) {
      tree.distance_m[i] = length_m;
      queue.emplace(length_m, static_cast<std::uint32_t>(i));
    }
  }
  while (!queue.empty()) {
    const auto [distance_m, place] = queue.top();
    queue.pop();
    if (distance_m > tree.distance_m[place]) {
      continue;
    }
    tree.order.push_back(place);
    for (const Edge& edge : edges_[place]) {
      const double through_m = distance_m + static_cast<double>(edge.length_m);
      if (through_m < tree.distance_m[edge.to]) {
        tree.distance_m[edge.to] = through_m;
        tree.parent[edge.to] = static_cast<std::int32_t>(place);
        queue.emplace(through_m, edge.to);
      }
    }
  }
  return tree;
}

}  // namespace echomap::source_search
