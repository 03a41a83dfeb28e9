// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "host/mapping/raster_map.hpp"

namespace echomap::tests {

/// Reads the map of Wean Hall (CMU, course 16-831; text, plain or gz), which belongs to the logs of
/// datasets::open_wean_log. Its lower left corner is the origin. A line of numbers is a COLUMN of
/// the map, x from the left, and holds its cells from y = 0 upwards. A number is -1 for unknown or
/// the probability that the cell is FREE, 0 to 1, although the description that comes with the file
/// calls it that of an obstacle. Thresholds are those of OccupancyGridParams. Throws
/// files::FileError whose text begins `file:line: `.
mapping::RasterMap read_wean_map(const std::filesystem::path& path);

}  // namespace echomap::tests
