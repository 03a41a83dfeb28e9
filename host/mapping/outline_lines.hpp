// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include <Eigen/Core>

#include "host/geometry/segment.hpp"
#include "host/mapping/floor_border.hpp"
#include "host/mapping/raster_map.hpp"
#include "host/mapping/wall_lines.hpp"

namespace echomap::mapping {

/// When a border follows a line. Shares are costs of a piece of border, of what it costs where no
/// line explains it. Ours, chosen in simulated rooms.
struct OutlineLineParams {
  /// A border that far from its line is not explained by it at all; nearer, the cost goes with the
  /// square of the distance.
  double max_deviation_m = 0.15;
  /// A line explains nothing farther than this from where it is known, along it.
  double reach_m = 1.0;
  /// The unknown between a border and a wall beyond it is bridged up to this depth,
  double bridged_m = 0.6;
  /// at this share.
  double bridged_share = 0.1;
  /// A border beside the unknown that is at no wall.
  double unknown_share = 0.3;
  /// The floor behind a wall that is not fitted from there: the wall has been drawn too long.
  double behind_share = 0.4;
  /// What a line costs that is no fitted wall's, as metres of border without a line: one parallel
  /// or at right angles to a fitted wall, and any other.
  double own_line_m = 0.03;
  double own_direction_m = 0.06;
  /// The border is cut into sides that no part of it is farther from, each a line of its own.
  double cut_tolerance_m = 0.06;
};

/// A line that a side of an outline may have.
struct OutlineLine {
  DirectedLine line;
  std::vector<geometry::Segment> pieces;  ///< Where it is known.
  bool is_fitted = false;                 ///< The line of a fitted wall.
  /// Whether there is a wall: a fitted one, or occupied cells behind most of it.
  bool is_wall = false;
  double cost_m = 0.0;  ///< Of having it at all, as a length of border.
};

/// The lines of fitted walls and those of the border itself, as they are and turned to the
/// directions of the walls.
std::vector<OutlineLine> outline_lines(const std::vector<BorderPoint>& border,
                                       const std::vector<geometry::Segment>& walls,
                                       const OutlineLineParams& params);

/// What a piece of border costs that follows each of the lines: 0 for one on it, 1 for one that it
/// does not explain.
std::vector<double> misfits(const std::vector<OutlineLine>& lines,
                            const BorderPoint& point,
                            const RasterMap& map,
                            const OutlineLineParams& params);

}  // namespace echomap::mapping
