// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "host/mapping/raster_map.hpp"

namespace echomap::apps {

/// The YAML file of the map of a run directory, or that file itself. Throws CommandError 1 for a
/// folder without a map, with what it is instead and what to type.
std::filesystem::path map_file_of(const std::filesystem::path& map);

/// The map of a run directory, or of the YAML file of a ROS map; of a run that followed its walls
/// the floor inside of the outline that it drew. Throws files::FileError, and CommandError 1 as
/// map_file_of and for a map without any floor where a robot could be.
mapping::RasterMap read_map(const std::filesystem::path& map);

}  // namespace echomap::apps
