// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "host/mapping/outline_sides.hpp"
#include "host/mapping/polygon_map.hpp"
#include "host/mapping/sonar_features.hpp"

namespace echomap::mapping {

/// How a room's outline is made of its map and its fitted walls.
struct RoomOutlineParams {
  /// Unknown pieces narrower than this are floor: nobody would stand there. Ours.
  double sliver_m = 0.15;
  OutlineSideParams sides;
  /// The outline of a map without fitted walls, or where the straight sides would cross.
  PolygonMapParams border;
};

/// The largest connected piece of free floor as a polygon whose sides along fitted walls have the
/// walls' lines and meet where these cross. What stands in it is a hole: a fitted circle a regular
/// polygon, anything else the border of the floor around it. Without walls and circles it is
/// `polygon_from_raster`; empty where no cell is free. Throws std::invalid_argument for invalid
/// parameters.
std::optional<PolygonMap> room_outline(const RasterMap& map,
                                       const SonarFeatures& features,
                                       const RoomOutlineParams& params = {});

}  // namespace echomap::mapping
