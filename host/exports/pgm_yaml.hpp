// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "host/mapping/raster_map.hpp"

namespace echomap::exports {

/// Writes a map as ROS map_server reads it: the YAML file and, beside it under the same name, the
/// PGM (P5; free 254, occupied 0, unknown 205; first row on top; mode trinary). free_thresh is
/// 0.196 so that an unknown pixel, 1 - 205 / 255 = 0.1961, never reads as free. Throws
/// files::FileError.
void write_pgm_yaml(const std::filesystem::path& yaml_path, const mapping::RasterMap& map);

/// Reads such a pair by the map_server's rules: thresholds and `negate` of the YAML file decide,
/// modes trinary and scale alike: what lies between the thresholds is a probability in mode scale,
/// but not of anything that is known. Throws files::FileError whose text begins `file:line: `.
mapping::RasterMap read_pgm_yaml(const std::filesystem::path& yaml_path);

}  // namespace echomap::exports
