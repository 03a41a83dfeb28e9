// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "hil_mock/world/floor_plan.hpp"

namespace echomap::runner {

/// What a cell of the true map holds, as the pixel value of a ROS map.
enum class TruthCell : std::uint8_t { kOccupied = 0, kUnknown = 205, kFree = 254 };

/// The room as a grid: walls are occupied, what could be reached from the start before anybody put
/// a box down is free, the rest, the holes and the insides of boxes unknown.
struct TruthMap {
  int width = 0;
  int height = 0;
  double resolution_m = 0.0;
  /// Lower left corner of the lower left cell, in the world frame.
  double origin_x_m = 0.0;
  double origin_y_m = 0.0;
  /// Row 0 is the lowest; within a row x grows.
  std::vector<TruthCell> cells;

  TruthCell at(int column, int row) const;
};

/// Draws the room in cells of `resolution_m`, with a margin around it.
TruthMap draw_truth_map(const world::FloorPlan& plan, double resolution_m);

}  // namespace echomap::runner
