// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>

#include "host/evaluation/map_agreement.hpp"
#include "host/geometry/pose2.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::evaluation {

/// How much of what is solid a map calls floor, and which obstacles it shows. The truth's obstacles
/// are what its `obstacle_rings` enclose.
struct ObstacleAgreement {
  /// Share of the area inside of obstacles, all together, that lies in free cells of the map; empty
  /// without an obstacle.
  std::optional<double> solid_called_free;
  /// The same for the band of 10 cm outside of the room's ring; empty without a ring.
  std::optional<double> wall_band_called_free;
  /// Obstacles of at least 10 cm from corner to corner, part of whose outline has truly free floor
  /// 3 cm outside of it: its visible outline.
  std::size_t objects = 0;
  /// Those of them of whose visible outline at least half has the centre of an occupied cell within
  /// 7.5 cm.
  std::size_t objects_found = 0;
};

/// `T_world_map` places the map in the world; nothing is fitted. Areas and outlines are sampled a
/// centimetre apart, or finer where an obstacle is that small.
ObstacleAgreement score_obstacles(const mapping::RasterMap& map,
                                  const geometry::Pose2& T_world_map,
                                  const MapTruth& truth);

}  // namespace echomap::evaluation
