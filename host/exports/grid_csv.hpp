// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "host/mapping/cell_field.hpp"
#include "host/mapping/occupancy_grid.hpp"

namespace echomap::exports {

/// occupancy_grid.csv: two comment lines that name and give resolution, origin (lower left corner,
/// metres) and size, then one line per row of cells, the top row (largest y) first. A cell is its
/// probability of being occupied, or -1 where it is unknown. Throws files::FileError.
void write_occupancy_grid_csv(const std::filesystem::path& path,
                              const mapping::OccupancyGrid& grid);

/// confidence_grid.csv: the same layout for the grid of a strategy that keeps one of its own
/// (Hennessey et al. call the file occupancy_grid.csv, the name that a run directory has for its
/// map). A cell is the confidence, from 0, that something stands there. In the strategy's frame.
/// Throws files::FileError.
void write_confidence_grid_csv(const std::filesystem::path& path,
                               const mapping::CellField& confidence);

}  // namespace echomap::exports
