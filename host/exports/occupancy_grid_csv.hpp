// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "host/mapping/occupancy_grid.hpp"

namespace echomap::exports {

/// occupancy_grid.csv: two comment lines that name and give resolution, origin (lower left corner,
/// metres) and size, then one line per row of cells, the top row (largest y) first. A cell is its
/// probability of being occupied, or -1 where it is unknown. Throws files::FileError.
void write_occupancy_grid_csv(const std::filesystem::path& path,
                              const mapping::OccupancyGrid& grid);

}  // namespace echomap::exports
