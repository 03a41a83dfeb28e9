// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>

#include "host/exports/map_style.hpp"
#include "host/mapping/polygon_map.hpp"
#include "host/pipeline/snapshot.hpp"

namespace echomap::exports {

/// map.png, the picture for people: floor white, occupied cells dark, unknown a pale hatch; the
/// outline as a wide line, fitted walls and obstacles as thin ones, SLAM's landmarks as lines and
/// dots, the robot's trail from its start (ring) to where it stands (disc with nose), the echoes as
/// faint dots, with title, legend, a scale bar in metres and a faint grid (grid_spacing_m). It
/// holds all of the trail. `style.turn_rad` turns the picture in the map frame; not turned, up is
/// +y. tEXt chunks say where it lies (MapView::texts). Throws files::FileError.
void write_map_png(const std::filesystem::path& path,
                   const pipeline::Snapshot& snapshot,
                   const std::optional<mapping::PolygonMap>& outline,
                   const MapStyle& style = {});

}  // namespace echomap::exports
