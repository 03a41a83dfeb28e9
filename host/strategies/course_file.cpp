// SPDX-License-Identifier: MIT
#include "host/strategies/course_file.hpp"

#include <cmath>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include "host/files/bundled_files.hpp"
#include "host/geometry/angle.hpp"
#include "host/session/profile_fields.hpp"

namespace echomap::strategies {
namespace {

using exploration::WaypointCourse;
using files::TomlReader;

/// A hall of 100 m in cells of 5 cm.
constexpr std::int64_t kMaxCells = 2000;

int cells_of(const TomlReader& grid, std::string_view key) {
  const std::int64_t cells = grid.integer(key);
  if (cells < 1 || cells > kMaxCells) {
    grid.fail(key, fmt::format("'{}' must be from 1 to {}", key, kMaxCells));
  }
  return static_cast<int>(cells);
}

void read_grid(const TomlReader& grid, WaypointCourse& course) {
  course.cell_m = session::positive(grid, "cell_m");
  const auto first = [&](std::string_view key) {
    return static_cast<int>(std::lround(grid.number_or(key, 0.0) / course.cell_m));
  };
  const int columns = cells_of(grid, "columns");
  const int rows = cells_of(grid, "rows");
  const geometry::CellIndex low{first("x_m"), first("y_m")};
  course.cells = {low, {low.x + columns - 1, low.y + rows - 1}};
}

void read_wall(const TomlReader& wall, std::vector<geometry::Segment>& walls) {
  const auto points_m = wall.points("points_m");
  if (points_m.size() < 2) {
    wall.fail("points_m", "a wall has two points or more");
  }
  for (std::size_t i = 1; i < points_m.size(); ++i) {
    walls.push_back({{points_m[i - 1][0], points_m[i - 1][1]}, {points_m[i][0], points_m[i][1]}});
  }
}

/// On the grid: what lies outside of it the robot knows nothing of.
Eigen::Vector2d read_place_m(const TomlReader& table, const WaypointCourse& course) {
  Eigen::Vector2d place_m(table.number("x_m"), table.number("y_m"));
  const Eigen::Array2d cell = (place_m / course.cell_m).array().floor();
  const bool is_on_it = cell.x() >= course.cells.min.x && cell.x() <= course.cells.max.x &&
                        cell.y() >= course.cells.min.y && cell.y() <= course.cells.max.y;
  if (!is_on_it) {
    table.fail("x_m", fmt::format("({:g}, {:g}) is not on the grid", place_m.x(), place_m.y()));
  }
  return place_m;
}

}  // namespace

WaypointCourse read_course(const TomlReader& file) {
  WaypointCourse course;
  course.name = file.text("name");
  read_grid(file.table("grid"), course);
  const TomlReader start = file.table("start");
  const Eigen::Vector2d start_m = read_place_m(start, course);
  course.T_course_start = {
      start_m.x(), start_m.y(), geometry::radians(start.number("heading_deg"))};
  for (const TomlReader& wall : file.tables("known_wall")) {
    read_wall(wall, course.known_walls);
  }
  for (const TomlReader& waypoint : file.tables("waypoint")) {
    course.waypoints.push_back({waypoint.text("name"), read_place_m(waypoint, course)});
  }
  if (course.waypoints.empty()) {
    file.fail("waypoint", "a course has one [[waypoint]] or more");
  }
  file.reject_unknown_keys();
  return course;
}

WaypointCourse load_course(const std::string& name_or_file) {
  return read_course(
      TomlReader::load(files::bundled_file(name_or_file, "host/courses", "course (--waypoints)")));
}

}  // namespace echomap::strategies
