// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "host/exploration/cost_grid.hpp"

namespace echomap::source_search {

/// Places of a floor where a robot can stand, spaced evenly, and the straight paths between
/// neighbours that it can drive. Where the middle of a square is closed, its place is an open cell
/// of the square: no door is too narrow to have one.
class DwellLattice {
 public:
  struct Edge {
    std::uint32_t to = 0;
    float length_m = 0.0F;
  };

  DwellLattice(const exploration::CostGrid& costs, double spacing_m);

  const std::vector<Eigen::Vector2d>& places_m() const { return places_m_; }
  const std::vector<Edge>& edges(std::size_t place) const { return edges_[place]; }

  /// Shortest paths from a place on the floor to all others.
  struct Tree {
    std::vector<double> distance_m;    ///< Infinite where no path leads.
    std::vector<std::int32_t> parent;  ///< -1 for the first place of a path.
    std::vector<std::uint32_t> order;  ///< Places that are reached, the nearest first.
  };
  Tree tree_from(const exploration::CostGrid& costs, const Eigen::Vector2d& from_m) const;

 private:
  double spacing_m_;
  std::vector<Eigen::Vector2d> places_m_;
  std::vector<std::vector<Edge>> edges_;
};

}  // namespace echomap::source_search
