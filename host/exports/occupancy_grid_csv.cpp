// SPDX-License-Identifier: MIT
#include "host/exports/occupancy_grid_csv.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
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

/// More cells than this in a row are a broken head, not a room.
constexpr double kMostColumns = 1e6;

/// The numbers of the comment line that gives resolution, origin, rows and columns.
NumberRow read_head(const std::filesystem::path& path) {
  std::istringstream lines(files::read_text_file(path));
  std::string names;
  std::string line;
  if (!std::getline(lines, names) || !names.starts_with("# resolution_m,") ||
      !std::getline(lines, line) || !line.starts_with("# ")) {
    fail_at_line(path, 1, "expected two lines '# resolution_m,..' and '# numbers'");
  }
  NumberRow head = parse_number_row(line.substr(2), {"", ',', 5}, path, 2);
  const auto& [resolution_m, columns] = std::pair(head.values[0], head.values[4]);
  if (!(resolution_m > 0.0) || columns < 1.0 || columns > kMostColumns ||
      columns != std::floor(columns)) {
    fail_at_line(path, 2, "resolution_m must be above 0 and columns a whole number from 1");
  }
  return head;
}

std::optional<double> probability_of(double value) {
  return value < 0.0 ? std::nullopt : std::optional(value);
}

}  // namespace

void write_occupancy_grid_csv(const std::filesystem::path& path,
                              const mapping::OccupancyGrid& grid) {
  const auto bounds = grid.bounds().empty() ? mapping::CellBounds{{0, 0}, {0, 0}} : grid.bounds();
  std::string text =
      "# resolution_m,origin_x_m,origin_y_m,rows,columns; origin is the lower left corner, the "
      "first "
      "row the top (largest y); p occupied in [0,1], -1 unknown\n# ";
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

std::optional<double> ProbabilityTable::at(int column, int row) const {
  if (column < 0 || column >= columns || row < 0 || row >= rows) {
    return std::nullopt;
  }
  return cells[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(column)];
}

ProbabilityTable read_occupancy_grid_csv(const std::filesystem::path& path) {
  const std::vector<double> head = read_head(path).values;
  auto table_rows = read_number_table(path, {"", ',', static_cast<std::size_t>(head[4])});
  if (static_cast<double>(table_rows.size()) != head[3]) {
    fail_at_line(path, 2, "the file has " + std::to_string(table_rows.size()) + " rows of cells");
  }
  ProbabilityTable table{head[0],
                         {head[1], head[2]},
                         static_cast<int>(head[4]),
                         static_cast<int>(table_rows.size()),
                         {}};
  std::reverse(table_rows.begin(), table_rows.end());
  for (const auto& [values, line] : table_rows) {
    for (const double value : values) {
      if (value > 1.0 || (value < 0.0 && value != kUnknown)) {
        fail_at_line(path, line, "a cell is a probability or -1");
      }
      table.cells.push_back(probability_of(value));
    }
  }
  return table;
}

}  // namespace echomap::exports
