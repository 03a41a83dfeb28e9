// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "host/geometry/polygon.hpp"
#include "host/geometry/pose2.hpp"
#include "host/geometry/segment.hpp"
#include "host/mapping/polygon_map.hpp"

namespace echomap::evaluation {

/// How well an outline agrees with that of the room's floor.
struct OutlineAgreement {
  std::size_t corners = 0;       ///< Of the outline; 0 for none.
  std::size_t room_corners = 0;  ///< Of the room's floor.
  /// Root mean square distance from each corner of the room to the nearest of the outline, metres;
  /// empty without an outline.
  std::optional<double> corner_rmse_m;
  /// Root mean square distance of points along both, a centimetre apart, to the other one, metres.
  std::optional<double> outline_rmse_m;
};

/// The polygons that walls in a row close, each wall beginning where the one before it ends. A
/// truth directory has the room's first, then those of the obstacles; a wall that closes nothing is
/// passed over.
std::vector<geometry::Polygon> closed_rings(const std::vector<geometry::Segment>& walls);

/// The first closed ring, the room's. Empty where no ring is closed.
geometry::Polygon first_ring(const std::vector<geometry::Segment>& walls);

/// The closed rings behind the first: what they enclose is solid.
std::vector<geometry::Polygon> obstacle_rings(const std::vector<geometry::Segment>& walls);

/// `T_world_map` places the outline in the world; nothing is fitted. `room_m` is the
/// `floor_outline` of the room.
OutlineAgreement score_outline(const std::optional<mapping::PolygonMap>& outline,
                               const geometry::Pose2& T_world_map,
                               const geometry::Polygon& room_m);

}  // namespace echomap::evaluation
