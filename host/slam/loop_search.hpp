// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "host/geometry/pose2.hpp"

namespace echomap::slam {

/// How places are looked for.
struct LoopSearchParams {
  double cell_m = 0.1;    ///< Edge of the cells that points are compared in, metres.
  double spread_m = 0.1;  ///< A point so far from the nearest one counts 0.61 (1 sigma).
  int levels = 6;         ///< The coarsest squares have 2^(levels - 1) cells along an edge.
  /// A turn that moves a point this far off by a cell is one step; farther points are moved more.
  double reach_m = 8.0;
  std::size_t max_points = 150;  ///< The more are compared, the longer it takes.
  double min_score = 0.5;        ///< Below, nothing is found.
};

/// Where to look.
struct SearchWindow {
  geometry::Pose2 T_map_robot;  ///< The middle.
  double radius_m = 0.0;        ///< Half the edge of the square of positions, up to whole cells.
  double turn_rad = 0.0;        ///< To either side, up to whole steps.
};

/// A place that was found.
struct FoundPlace {
  geometry::Pose2 T_map_robot;
  double score = 0.0;  ///< Mean over the points, in [0, 1].
};

/// Finds the pose, of all on a lattice within a window, at which points agree best with points of
/// the map: branch and bound over squares of positions (Hess et al. 2016, algorithm 3). The best of
/// the lattice is found for certain.
class LoopSearch {
 public:
  /// Throws std::invalid_argument for invalid parameters.
  explicit LoopSearch(const LoopSearchParams& params = {});

  /// `map_points_m` in the map, `points_m` in the robot's frame. Empty where nothing reaches the
  /// least score.
  std::optional<FoundPlace> find(std::span<const Eigen::Vector2d> map_points_m,
                                 std::span<const Eigen::Vector2d> points_m,
                                 const SearchWindow& window);

 private:
  /// A square of positions of 2^level cells, at one heading.
  struct Branch {
    int x = 0;
    int y = 0;
    int level = 0;
    double score = 0.0;  ///< No position in it has more.
  };
  struct Cell {
    int x = 0;
    int y = 0;
  };

  void draw(std::span<const Eigen::Vector2d> map_points_m);
  /// What a point counts in the cells around it, row by row.
  std::vector<std::uint8_t> drawn_point() const;
  int reach_cells() const;
  void draw_point(const Eigen::Vector2d& point_m, const std::vector<std::uint8_t>& drawn);
  void add_level(int level);
  std::vector<Cell> cells_of(std::span<const Eigen::Vector2d> points_m,
                             const Eigen::Vector2d& position_m,
                             double heading_rad) const;
  double score(const std::vector<Cell>& cells, const Branch& branch) const;
  /// Improves the best by what is within a branch and at most `radius` cells from the middle.
  void search(const std::vector<Cell>& cells, int radius, const Branch& branch, Branch& best) const;
  std::uint8_t at(int level, int x, int y) const;

  LoopSearchParams params_;
  Eigen::Vector2d origin_m_ = Eigen::Vector2d::Zero();
  int columns_ = 0;
  int rows_ = 0;
  /// By level: the most of the cells right of and above a cell, 2^level along an edge.
  std::vector<std::vector<std::uint8_t>> max_;
};

}  // namespace echomap::slam
