// SPDX-License-Identifier: MIT
#include "tests/support/run_tables.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

#include "host/exports/number_table.hpp"
#include "host/files/atomic_file.hpp"

namespace echomap::tests {
namespace {

using exports::fail_at_line;
using exports::NumberRow;
using exports::NumberTableFormat;
using exports::parse_number_row;
using exports::read_number_table;

constexpr NumberTableFormat kPointsFormat{"x_m,y_m,pose_index", ',', 3};
constexpr NumberTableFormat kPosesFormat{"x_m,y_m,heading_rad", ',', 3};
constexpr double kUnknown = -1.0;

/// More cells than this in a row are a broken head, not a room.
constexpr double kMaxColumns = 1e6;

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
  if (!(resolution_m > 0.0) || columns < 1.0 || columns > kMaxColumns ||
      columns != std::floor(columns)) {
    fail_at_line(path, 2, "resolution_m must be above 0 and columns a whole number from 1");
  }
  return head;
}

std::optional<double> probability_of(double value) {
  return value < 0.0 ? std::nullopt : std::optional(value);
}

}  // namespace

std::vector<mapping::MapPoint> read_points_csv(const std::filesystem::path& path) {
  std::vector<mapping::MapPoint> points;
  for (const auto& [row, line] : read_number_table(path, kPointsFormat)) {
    const bool is_index = row[2] >= 0.0 && row[2] < 4294967296.0 && row[2] == std::floor(row[2]);
    if (!is_index) {
      fail_at_line(path, line, "pose_index must be a whole number from 0");
    }
    points.push_back({{row[0], row[1]}, static_cast<std::size_t>(row[2])});
  }
  return points;
}

std::vector<geometry::Pose2> read_poses_csv(const std::filesystem::path& path) {
  std::vector<geometry::Pose2> poses;
  for (const auto& row : read_number_table(path, kPosesFormat)) {
    poses.emplace_back(row.values[0], row.values[1], row.values[2]);
  }
  return poses;
}

mapping::PointCloudMap read_point_cloud_map(const std::filesystem::path& run_directory) {
  const auto points_path = run_directory / "points.csv";
  try {
    return {read_poses_csv(run_directory / "poses.csv"), read_points_csv(points_path)};
  } catch (const std::invalid_argument& error) {
    throw files::FileError(points_path.string() + ": " + error.what());
  }
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

}  // namespace echomap::tests
