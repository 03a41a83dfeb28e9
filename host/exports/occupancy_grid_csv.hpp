// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "host/mapping/occupancy_grid.hpp"

namespace echomap::exports {

/// occupancy_grid.csv: two comment lines that name and give resolution, origin (lower left corner,
/// metres) and size, then one line per row of cells, the top row (largest y) first. A cell is its
/// probability of being occupied, or -1 where it is unknown. Throws files::FileError.
void write_occupancy_grid_csv(const std::filesystem::path& path,
                              const mapping::OccupancyGrid& grid);

/// What occupancy_grid.csv holds.
struct ProbabilityTable {
  double resolution_m = 0.0;
  /// The lower left corner in the map frame.
  Eigen::Vector2d origin_m = Eigen::Vector2d::Zero();
  int columns = 0;
  int rows = 0;
  /// Of being occupied, row by row from the lowest, each from the left; empty where unknown.
  std::vector<std::optional<double>> cells;

  /// Unknown outside.
  std::optional<double> at(int column, int row) const;
};

/// Throws files::FileError whose text begins `file:line: ` where the file is not as above.
ProbabilityTable read_occupancy_grid_csv(const std::filesystem::path& path);

}  // namespace echomap::exports
