// SPDX-License-Identifier: MIT
#pragma once

#include "host/mapping/raster_map.hpp"

namespace echomap::papers {

/// How a grid of `epuck_field` agrees with it. Shares are 0 to 1.
struct EpuckGridFigures {
  double walls_found = 0.0;        ///< Share of the walls' length, an occupied cell within 3 mm.
  double walls_about = 0.0;        ///< The same, within 1 cm.
  double occupied_near = 0.0;      ///< Share of the occupied cells within 5 mm of a wall.
  double occupied_rms_m = 0.0;     ///< Root mean square distance of occupied cells to a wall.
  double occupied_median_m = 0.0;  ///< Median of these distances.
  double free_found = 0.0;         ///< Share of the true floor that is called free.
  double free_wrong = 0.0;         ///< Share of what is called free that is no floor.
  double deepest_m = 0.0;       ///< How far behind a wall the deepest cell is that is not unknown.
  double blocks_unknown = 0.0;  ///< Share of the blocks' insides that is unknown.
};

/// Scores a grid in the world frame by the centres of its cells.
EpuckGridFigures epuck_grid_figures(const mapping::RasterMap& map);

/// Calls all unknown clots free that are smaller than the robot (section 4.1).
mapping::RasterMap without_small_clots(mapping::RasterMap map);

}  // namespace echomap::papers
