// SPDX-License-Identifier: MIT
#include "host/exports/confidence_grid_csv.hpp"

#include <cmath>
#include <string>
#include <vector>

#include "host/exports/number_table.hpp"
#include "host/files/atomic_file.hpp"

namespace echomap::exports {

void write_confidence_grid_csv(const std::filesystem::path& path,
                               const mapping::CellField& confidence) {
  const auto& bounds = confidence.bounds();
  std::string text =
      "# resolution_m,origin_x_m,origin_y_m,rows,columns; origin is the lower left corner, the "
      "first row the top (largest y); confidence from 0\n# ";
  const std::vector<double> geometry{confidence.resolution_m(),
                                     bounds.min.x * confidence.resolution_m(),
                                     bounds.min.y * confidence.resolution_m(),
                                     static_cast<double>(bounds.rows()),
                                     static_cast<double>(bounds.columns())};
  append_row(text, geometry, ',');
  std::vector<double> row(static_cast<std::size_t>(bounds.columns()));
  for (std::int32_t y = bounds.max.y; y >= bounds.min.y; --y) {
    for (std::int32_t x = bounds.min.x; x <= bounds.max.x; ++x) {
      const double value = confidence[confidence.index({x, y})];
      row[static_cast<std::size_t>(x - bounds.min.x)] = std::round(value * 1e4) / 1e4;
    }
    append_row(text, row, ',');
  }
  files::write_text_file(path, text);
}

}  // namespace echomap::exports
