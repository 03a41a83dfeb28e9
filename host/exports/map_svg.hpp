// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>

#include "host/exports/map_style.hpp"
#include "host/mapping/polygon_map.hpp"
#include "host/pipeline/snapshot.hpp"

namespace echomap::exports {

/// map.svg, the map to print and to draw on, on an SvgSheet at a round scale. Paths `floor`,
/// `grid`, `walls`, `outline`, `echoes`, `trail`, `start`, `robot`, `fitted`, the lines of
/// fitted walls and obstacles, and `landmarks` are in metres of the map frame; all are turned
/// together by `style.turn_rad`. Throws files::FileError.
void write_map_svg(const std::filesystem::path& path,
                   const pipeline::Snapshot& snapshot,
                   const std::optional<mapping::PolygonMap>& outline,
                   const MapStyle& style = {});

}  // namespace echomap::exports
