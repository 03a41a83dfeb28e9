// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "host/geometry/segment.hpp"
#include "host/mapping/polygon_map.hpp"

namespace echomap::exports {

/// outline.geojson: one Polygon, or no feature where there is no map. Positions are metres of the
/// map frame and not longitude and latitude as RFC 7946 has it; `crs` in the properties says so.
/// `corners` there has one word for each corner of the outline: "reflex" or "non-reflex"; `sides`
/// one for the side from there to the next corner, "wall" or "open", if `is_open` is known. Throws
/// files::FileError.
void write_outline_geojson(const std::filesystem::path& path,
                           const std::optional<mapping::PolygonMap>& map,
                           const std::vector<bool>& is_open = {});

/// The first Polygon of a file; empty where there is none. Throws files::FileError that names the
/// file, also where its rings are no floor.
std::optional<mapping::PolygonMap> read_outline_geojson(const std::filesystem::path& path);

/// The same of the file's text; `file` stands for it in messages.
std::optional<mapping::PolygonMap> parse_outline_geojson(const std::string& text,
                                                         const std::string& file);

/// Every piece of every LineString of a file; other geometries are passed over. Throws
/// files::FileError that names the file.
std::vector<geometry::Segment> read_line_strings(const std::filesystem::path& path);

}  // namespace echomap::exports
