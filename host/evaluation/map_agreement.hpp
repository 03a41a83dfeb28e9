// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "host/geometry/pose2.hpp"
#include "host/geometry/segment.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::evaluation {

/// The room as it is, in the world frame: cells free where the robot could be, and the walls.
struct MapTruth {
  mapping::RasterMap cells;
  std::vector<geometry::Segment> walls;
};

/// How well a map agrees with the truth (docs/architecture.md names the scores; their definitions
/// stand here).
struct MapAgreement {
  /// Intersection over union of the map's free cells and the cells of the map's grid whose centres
  /// lie on truly free floor; 1 where both are empty.
  double free_iou = 0.0;
  /// Root mean square distance from the centre of each occupied cell to the nearest true wall,
  /// metres; empty without an occupied cell.
  std::optional<double> wall_rmse_m;
  /// Share of the wall length bordering truly free floor that has an occupied cell's centre within
  /// `wall_reach_m`.
  double wall_recall = 0.0;
};

/// The map's cells that cover both it and the truth. Throws std::invalid_argument where they lie so
/// far apart that no grid can cover both.
mapping::CellBounds cells_of_both(const mapping::RasterMap& map,
                                  const geometry::Pose2& T_world_map,
                                  const mapping::RasterMap& truth);

/// How near an occupied cell's centre must be to count for a wall: 5 cm, or one cell if that is
/// larger.
double wall_reach_m(const mapping::RasterMap& map);

/// `T_world_map` places the map in the world; nothing is fitted. Throws std::invalid_argument where
/// map and truth lie so far apart that no grid can cover both.
MapAgreement score_map(const mapping::RasterMap& map,
                       const geometry::Pose2& T_world_map,
                       const MapTruth& truth);

}  // namespace echomap::evaluation
