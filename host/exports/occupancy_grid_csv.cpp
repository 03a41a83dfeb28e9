// SPDX-License-Identifier: MIT
#include "host/exports/occupancy_grid_csv.hpp"

#include <cmath>
#include <string>

#include "host/exports/number_table.hpp"
#include "host/files/atomic_file.hpp"

namespace echomap::exports {

namespace {

constexpr double kUnknown = -1.0;

/// To four decimals, which tell any two log-odds in the grid's range apart where it matters.
double cell_value(const mapping::OccupancyGrid& grid, geometry::CellIndex cell) {
  const auto probability = grid.probability(cell);
  return probability ? std::round(*probability * 1e4) / 1e4 : kUnknown;
}

}  // namespace

void write_occupancy_grid_csv(const std::filesystem::path& path,
                              const mapping::OccupancyGrid& grid) {
  const auto bounds = grid.bounds().empty() ? mapping::CellBounds{{0, 0}, {0, 0}} : grid.bounds();
  std::string text =
      "# resolution_m,origin_x_m,origin_y_m,rows,columns; origin is the lower left corner, the "
      "first row the top (largest y); p occupied in [0,1], -1 unknown\n# ";
  const std::vector<double> geometry{grid.resolution_m(),
                                     bounds.min.x * grid.resolution_m(),
                                     bounds.min.y * grid.resolution_m(),
                                     static_cast<double>(bounds.rows()),
                                     static_cast<double>(bounds.columns())};
  append_row(text, geometry, ',');
  std::vector<double> row(static_cast<std::size_t>(bounds.columns()));
  for (std::int32_t y = bounds.max.y; y >= bounds.min.y; --y) {
    for (std::int32_t x = bounds.min.x; x <= bounds.max.x; ++x) {
      row[static_cast<std::size_t>(x - bounds.min.x)] = cell_value(grid, {x, y});
    }
    append_row(text, row, ',');
  }
  files::write_text_file(path, text);
}

}  // namespace echomap::exports
