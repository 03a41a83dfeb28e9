// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "host/mapping/raster_map.hpp"

namespace echomap::papers {

/// Draws a grid as figure 5 (left) of Mahmood and Ridao 2017 does: obstacles white, free cells
/// black, unknown ones grey. Writes it to `file` and returns the bytes of the PNG file. Throws
/// files::FileError.
std::vector<std::uint8_t> draw_in_shades(const std::filesystem::path& file,
                                         const mapping::RasterMap& map);

/// Draws a grid with the true walls of `epuck_field` on it, as figure 5 (right): obstacles black,
/// free cells white, unknown ones grey. Throws files::FileError.
std::vector<std::uint8_t> draw_under_walls(const std::filesystem::path& file,
                                           const mapping::RasterMap& map);

}  // namespace echomap::papers
