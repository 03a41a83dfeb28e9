// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "host/geometry/polygon.hpp"

namespace echomap::geometry {

/// An outline as Mukherjee et al., section V-C, tell its inside from its outside: the polygon of
/// its non-reflex corners, less the sub-polygons that each run of reflex corners makes with the
/// corners before and behind it, which are cut into triangles. For many points against one outline:
/// no square roots, no divisions.
///
/// The paper takes the polygon of non-reflex corners for convex, the sub-polygons too, and none of
/// them to lie in another; that holds for simple rooms. Here the cut is made again and again until
/// no reflex corner is left, and triangles count with the sense in which their corners run: what is
/// cut away twice comes back. So it holds for any outline that does not cross itself.
class ReflexOutline {
 public:
  /// Of either sense. Throws std::invalid_argument for a polygon_fault.
  explicit ReflexOutline(Polygon outline_m);

  /// Points on a side belong to either.
  bool contains(const Eigen::Vector2d& point_m) const;

  /// A triangle of the cut; clockwise, it is taken away.
  struct Triangle {
    Eigen::Vector2d a_m = Eigen::Vector2d::Zero();
    Eigen::Vector2d b_m = Eigen::Vector2d::Zero();
    Eigen::Vector2d c_m = Eigen::Vector2d::Zero();
  };
  const std::vector<Triangle>& triangles() const { return triangles_; }

 private:
  void add_fan(const Polygon& corners_m);

  std::vector<Triangle> triangles_;
};

/// One step of the paper's cut, of an outline that runs counter-clockwise.
struct ReflexCut {
  Polygon outer_m;               ///< The non-reflex corners.
  std::vector<Polygon> parts_m;  ///< A run of reflex corners each, between its neighbours.
};

/// The cut; without parts where no corner is reflex or none is not.
ReflexCut cut_reflex_corners(const Polygon& outline_m);

}  // namespace echomap::geometry
