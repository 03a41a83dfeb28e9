// SPDX-License-Identifier: MIT
#include "tests/support/wean_map.hpp"

#include <string>
#include <string_view>

#include "host/datasets/field_cursor.hpp"
#include "host/datasets/line_reader.hpp"
#include "host/geometry/cell_index.hpp"

namespace echomap::tests {
namespace {

using datasets::FieldCursor;
using datasets::LineReader;
using mapping::CellState;

constexpr double kMetresPerCentimetre = 0.01;
/// A larger map is damage.
constexpr std::int64_t kMaxCellsASide = 8000;

/// The next line that is not empty.
std::string_view next_line(LineReader& lines, const char* expected) {
  while (const auto line = lines.next()) {
    if (line->find_first_not_of(" \t") != std::string_view::npos) {
      return *line;
    }
  }
  lines.fail(std::string("the file ends before ") + expected);
}

/// The number of a line `robot_specifications->NAME NUMBER`.
double specified(LineReader& lines, const std::string& name) {
  FieldCursor fields(lines, next_line(lines, name.c_str()));
  const std::string expected = "robot_specifications->" + name;
  if (const std::string_view key = fields.word("the name of a number"); key != expected) {
    fields.fail("the name of a number", key, "not " + expected);
  }
  const double number = fields.number(name.c_str());
  fields.expect_end();
  return number;
}

/// How many cells the map has along one axis, which has to be what its length says.
int read_side(FieldCursor& fields, double length_cm, double resolution_cm) {
  const std::int64_t cells = fields.integer("the number of cells");
  if (cells < 1 || cells > kMaxCellsASide ||
      static_cast<double>(cells) * resolution_cm != length_cm) {
    fields.fail("the number of cells", std::to_string(cells), "not what the map's size says");
  }
  return static_cast<int>(cells);
}

mapping::RasterMap read_head(LineReader& lines) {
  const double x_cm = specified(lines, "global_mapsize_x");
  const double y_cm = specified(lines, "global_mapsize_y");
  const double resolution_cm = specified(lines, "resolution");
  if (!(resolution_cm > 0.0)) {
    lines.fail("a resolution that is not above 0");
  }
  for (const char* shift : {"autoshifted_x", "autoshifted_y"}) {
    if (specified(lines, shift) != 0.0) {
      lines.fail("a shifted map is not supported");
    }
  }
  FieldCursor fields(lines, next_line(lines, "the size of the map"));
  if (const std::string_view key = fields.word("the size of the map"); key != "global_map[0]:") {
    fields.fail("the size of the map", key, "not global_map[0]:");
  }
  const int columns = read_side(fields, x_cm, resolution_cm);
  const int rows = read_side(fields, y_cm, resolution_cm);
  fields.expect_end();
  return {columns, rows, resolution_cm * kMetresPerCentimetre, Eigen::Vector2d::Zero()};
}

CellState read_cell(FieldCursor& fields) {
  static const mapping::OccupancyGridParams thresholds;
  const double free = fields.number("a cell");
  if (free == -1.0) {
    return CellState::kUnknown;
  }
  if (free < 0.0 || free > 1.0) {
    fields.fail("a cell", std::to_string(free), "neither -1 nor from 0 to 1");
  }
  const double occupied = 1.0 - free;
  if (occupied >= thresholds.occupied_threshold) {
    return CellState::kOccupied;
  }
  return occupied <= thresholds.free_threshold ? CellState::kFree : CellState::kUnknown;
}

}  // namespace

mapping::RasterMap read_wean_map(const std::filesystem::path& path) {
  LineReader lines(path);
  mapping::RasterMap map = read_head(lines);
  for (int x = 0; x < map.columns(); ++x) {
    FieldCursor fields(lines, next_line(lines, "the last column of the map"));
    for (int y = 0; y < map.rows(); ++y) {
      map.set({x, y}, read_cell(fields));
    }
    fields.expect_end();
  }
  while (const auto line = lines.next()) {
    FieldCursor(lines, *line).expect_end();
  }
  return map;
}

}  // namespace echomap::tests
