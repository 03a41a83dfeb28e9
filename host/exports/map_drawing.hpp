// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "host/exports/map_style.hpp"
#include "host/exports/map_view.hpp"
#include "host/exports/picture.hpp"
#include "host/mapping/polygon_map.hpp"
#include "host/pipeline/snapshot.hpp"

namespace echomap::exports {

/// Draws what a snapshot knows onto the cells of `view`: echoes as faint dots, the outline as a
/// wide line, fitted walls and obstacles as thin ones, SLAM's landmarks, the trail from its start
/// (ring) to the robot (disc with nose). Title and footer stay free of what lies beyond the view.
/// map.png and the frames of an animation are drawn by it. Of `style` it takes the robot's radius
/// and what is shown; title, legend and turn are those of the view.
Picture draw_map(const MapView& view,
                 const pipeline::Snapshot& snapshot,
                 const std::optional<mapping::PolygonMap>& outline,
                 const MapStyle& style);

}  // namespace echomap::exports
