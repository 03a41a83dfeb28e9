// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <set>
#include <vector>

#include <Eigen/Core>

#include "host/geometry/cell_index.hpp"
#include "host/geometry/polygon.hpp"

namespace echomap::exploration {

/// A drive along one wall that came round: where the middle of the robot was. Ways round what
/// stands in the room run clockwise.
struct WallLoop {
  geometry::Polygon path_m;
  bool is_island = false;
};

/// What floor a robot has had within reach, and what of the room is left. Ours.
class CoveredGround {
 public:
  /// Covers what is within `reach_m`; knows it to `cell_m`. Throws std::invalid_argument unless
  /// both are above zero.
  CoveredGround(double reach_m, double cell_m);

  void cover(const Eigen::Vector2d& place_m);
  bool is_covered(const Eigen::Vector2d& place_m) const;
  /// A place that cannot be reached, and what is within half the reach of it.
  void give_up(const Eigen::Vector2d& place_m);
  /// The robot has been round a wall; what lies behind it is no floor.
  void add(WallLoop loop) { loops_.push_back(std::move(loop)); }
  const std::vector<WallLoop>& loops() const { return loops_; }
  bool knows_the_room() const;

  /// The nearest floor that is next to covered floor and was not within reach; empty where none is
  /// left.
  std::optional<Eigen::Vector2d> nearest_left_m(const Eigen::Vector2d& place_m) const;

 private:
  void add_disc(const Eigen::Vector2d& place_m,
                double radius_m,
                std::set<geometry::CellIndex>& cells) const;
  geometry::CellIndex cell_at(const Eigen::Vector2d& place_m) const;
  Eigen::Vector2d center_m(geometry::CellIndex cell) const;
  bool may_be_floor(const Eigen::Vector2d& place_m) const;

  double reach_m_;
  double cell_m_;
  std::set<geometry::CellIndex> covered_;
  std::set<geometry::CellIndex> given_up_;
  std::vector<WallLoop> loops_;
};

}  // namespace echomap::exploration
