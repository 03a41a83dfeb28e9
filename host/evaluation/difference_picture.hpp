// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "host/evaluation/map_difference.hpp"

namespace echomap::evaluation {

/// Draws the first map, the walls of the second laid onto it and the regions that changed, with a
/// legend and a scale bar, as PNG. Throws files::FileError.
void write_difference_picture(const std::filesystem::path& path,
                              const mapping::RasterMap& before,
                              const mapping::RasterMap& after,
                              const MapDifference& difference);

}  // namespace echomap::evaluation
