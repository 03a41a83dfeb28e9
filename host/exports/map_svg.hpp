// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>

#include "host/exports/map_style.hpp"
#include "host/mapping/polygon_map.hpp"
#include "host/pipeline/snapshot.hpp"

namespace echomap::exports {

/// map.svg, the map to print and to draw on: one unit is one metre, and printed at its own size the
/// scale is 1 : 20. Groups `floor`, `walls`, `outline`, `echoes`, `trail` and `robot` are in
/// coordinates of the map frame, `fitted`, the lines of fitted walls and obstacles, too; all are
/// turned together by `style.turn_rad`. Around them are a title, `scale`, a bar in metres, and a
/// legend. Throws files::FileError.
void write_map_svg(const std::filesystem::path& path,
                   const pipeline::Snapshot& snapshot,
                   const std::optional<mapping::PolygonMap>& outline,
                   const MapStyle& style = {});

}  // namespace echomap::exports
