// SPDX-License-Identifier: MIT
#include "host/exports/grid_csv.hpp"

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "host/exports/number_table.hpp"
#include "host/files/atomic_file.hpp"

namespace echomap::exports {

namespace {

/// Values to four decimals, which tell any two log-odds in the grid's range apart where it matters.
template <class ValueOf>
void write_grid(const std::filesystem::path& path,
                const mapping::CellBounds& bounds,
                double resolution_m,
                std::string_view meaning,
                const ValueOf& value_of) {
  std::string text =
      "# resolution_m,origin_x_m,origin_y_m,rows,columns; origin is the lower left corner, the "
      "first row the top (largest y); ";
  text.append(meaning).append("\n# ");
  const std::vector<double> geometry{resolution_m,
                                     bounds.min.x * resolution_m,
                                     bounds.min.y * resolution_m,
                                     static_cast<double>(bounds.rows()),
                                     static_cast<double>(bounds.columns())};
  append_row(text, geometry, ',');
  std::vector<double> row(static_cast<std::size_t>(bounds.columns()));
  for (std::int32_t y = bounds.max.y; y >= bounds.min.y; --y) {
    for (std::int32_t x = bounds.min.x; x <= bounds.max.x; ++x) {
      const double value = value_of(geometry::CellIndex{x, y});
      row[static_cast<std::size_t>(x - bounds.min.x)] = std::round(value * 1e4) / 1e4;
    }
    append_row(text, row, ',');
  }
  files::write_text_file(path, text);
}

}  // namespace

void write_occupancy_grid_csv(const std::filesystem::path& path,
                              const mapping::OccupancyGrid& grid) {
  constexpr double kUnknown = -1.0;
  write_grid(path,
             grid.bounds().empty() ? mapping::CellBounds{{0, 0}, {0, 0}} : grid.bounds(),
             grid.resolution_m(),
             "p occupied in [0,1], -1 unknown",
             [&](geometry::CellIndex cell) { return grid.probability(cell).value_or(kUnknown); });
}

void write_confidence_grid_csv(const std::filesystem::path& path,
                               const mapping::CellField& confidence) {
  write_grid(path,
             confidence.bounds(),
             confidence.resolution_m(),
             "confidence from 0",
             [&](geometry::CellIndex cell) { return confidence[confidence.index(cell)]; });
}

}  // namespace echomap::exports
