// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "host/mapping/floor_border.hpp"
#include "host/mapping/outline_lines.hpp"
#include "host/mapping/raster_map.hpp"
#include "host/mapping/wall_lines.hpp"

namespace echomap::mapping {

/// What a corner costs. Ours, chosen in simulated rooms.
struct LineSequenceParams {
  /// As a length of border that no line explains: so much more an outline with one more corner has
  /// to explain.
  double corner_cost_m = 0.15;
  /// A corner costs twice as much where the lines cross that far from the border, and so on with
  /// the square of the distance.
  double corner_reach_m = 0.5;
  /// The same where they cross on the floor, which is known to have no corner there.
  double floor_corner_reach_m = 0.15;
  /// Lines that turn by less do not meet in a corner: there is a step between them, of two corners.
  double min_turn_rad = 0.26;
};

/// Where two lines meet in a corner near to a place of the border, and what that costs.
struct LineCorner {
  Eigen::Vector2d position_m = Eigen::Vector2d::Zero();
  double cost_m = 0.0;
};

/// Empty where there is a step between the two lines instead: they hardly turn, or cross too far
/// from there.
std::optional<LineCorner> line_corner(const DirectedLine& before,
                                      const DirectedLine& after,
                                      const Eigen::Vector2d& border_m,
                                      const RasterMap& map,
                                      const LineSequenceParams& params);

/// A piece of border, from point `begin` up to, but without, `end`, that follows one line. `end`
/// may lie beyond the ring's last point.
struct LineRun {
  std::size_t line = 0;
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// The lines that explain a ring of border at the least cost: that of its pieces, of the lines and
/// of the corners between them, which is a description of minimum length (Rissanen 1978) of the
/// border. Found by dynamic programming along the ring (Perez and Vidal 1994), three times around
/// for its beginning not to matter. `misfits` are by point and line; a run begins at no point that
/// its line does not explain. The runs are in order and cover the ring; none where one line
/// explains all.
std::vector<LineRun> line_sequence(const std::vector<BorderPoint>& border,
                                   const std::vector<OutlineLine>& lines,
                                   const std::vector<std::vector<double>>& misfits,
                                   const RasterMap& map,
                                   const LineSequenceParams& params);

}  // namespace echomap::mapping
