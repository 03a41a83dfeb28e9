// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "host/geometry/pose2.hpp"
#include "host/mapping/raster_map.hpp"
#include "host/terminal_view/terminal_kind.hpp"

namespace echomap::terminal_view {

/// What is drawn on the cells of a map, in the map frame.
struct MapMarks {
  std::optional<geometry::Pose2> T_map_robot{};  ///< An arrow; empty: none.
  std::vector<Eigen::Vector2d> trail_m{};        ///< Where the robot has been.
  std::vector<Eigen::Vector2d> particles_m{};    ///< Where it may be.
};

/// A map in characters.
struct MapDrawing {
  std::vector<std::string> lines{};  ///< Each takes `columns`.
  int columns = 0;
  double column_m = 0.0;  ///< Length in the room that a column is wide, and half a line is high.
};

/// Draws the known part of a map into `room`, one cell or more a pixel: a pixel with any occupied
/// cell is occupied, one with any free cell and none occupied is free, all others are unknown. A
/// pixel shows the same ground while the map grows, until the scale changes. There are no lines
/// where the room is smaller than 2 x 2.
MapDrawing draw_map(const mapping::RasterMap& map,
                    const MapMarks& marks,
                    TextSize room,
                    Glyphs glyphs);

/// What the characters or colours of such a drawing mean, an entry each: wall, floor, unknown, path
/// and particles.
std::vector<std::string> map_legend(Glyphs glyphs);

}  // namespace echomap::terminal_view
