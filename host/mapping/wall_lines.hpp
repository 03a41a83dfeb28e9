// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "host/geometry/segment.hpp"

namespace echomap::mapping {

/// A straight line without ends, with the floor to the left of its direction.
struct DirectedLine {
  Eigen::Vector2d point_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX();  ///< Of length 1.

  /// How far to the left of the line a point is, metres.
  double left_m(const Eigen::Vector2d& place_m) const;
  /// The foot of the perpendicular from a point.
  Eigen::Vector2d foot_of(const Eigen::Vector2d& place_m) const;
  /// Where two lines cross; empty where they are parallel.
  std::optional<Eigen::Vector2d> crossing(const DirectedLine& other) const;
};

/// One wall: the line of one or several pieces in a row.
struct MergedWall {
  DirectedLine line;
  std::vector<geometry::Segment> pieces;
};

/// Least-squares line through points in order, directed from the first to the last. Throws
/// std::invalid_argument for fewer than two points or points that are all in one place.
DirectedLine line_through(const std::vector<Eigen::Vector2d>& points_m);

/// Puts pieces of one wall together: those of the same sense whose ends are no farther than
/// `tolerance_m` from one line.
std::vector<MergedWall> merged_walls(std::vector<geometry::Segment> pieces, double tolerance_m);

}  // namespace echomap::mapping
