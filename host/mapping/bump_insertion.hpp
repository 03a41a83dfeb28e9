// SPDX-License-Identifier: MIT
#pragma once

#include "host/geometry/pose2.hpp"
#include "host/geometry/segment.hpp"
#include "host/mapping/occupancy_grid.hpp"

namespace echomap::mapping {

/// How much a bump says.
struct BumpParams {
  /// For each cell of the line, hundredths of log-odds: p = 0.95. A switch that closes has met
  /// something, so one bump makes a wall and several rays have to go through it before it is gone.
  int hit_centilogits = 294;
};

/// Marks what a bumper has met: every cell of the line that it has met it on, once. The line is in
/// the robot's frame (models::bumper_line; Hennessey et al., section II.B). Nothing is said of the
/// floor behind it.
void insert_bump(const geometry::Pose2& T_map_robot,
                 const geometry::Segment& line_m,
                 const BumpParams& params,
                 OccupancyGrid& grid);

}  // namespace echomap::mapping
