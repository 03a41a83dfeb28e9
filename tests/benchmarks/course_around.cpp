// SPDX-License-Identifier: MIT
#include "tests/benchmarks/course_around.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "host/files/atomic_file.hpp"
#include "host/geometry/angle.hpp"

namespace echomap::bench {

namespace {

using exploration::Waypoint;
using exploration::WaypointCourse;

/// The smallest box around points.
struct Box {
  Eigen::Array2d low_m;
  Eigen::Array2d high_m;
};

Box box_around(const geometry::Polygon& points_m) {
  Box box{points_m.front(), points_m.front()};
  for (const Eigen::Vector2d& point_m : points_m) {
    box.low_m = box.low_m.min(point_m.array());
    box.high_m = box.high_m.max(point_m.array());
  }
  return box;
}

/// Counter-clockwise, from the one nearest to the start.
std::array<Eigen::Vector2d, 4> corners_m(const Box& box, const Eigen::Vector2d& start_m) {
  std::array<Eigen::Vector2d, 4> corners_m{Eigen::Vector2d(box.low_m),
                                           {box.high_m.x(), box.low_m.y()},
                                           Eigen::Vector2d(box.high_m),
                                           {box.low_m.x(), box.high_m.y()}};
  const auto first = std::min_element(
      corners_m.begin(), corners_m.end(), [&](const auto& one_m, const auto& other_m) {
        return (one_m - start_m).norm() < (other_m - start_m).norm();
      });
  std::rotate(corners_m.begin(), first, corners_m.end());
  return corners_m;
}

/// What lies between two waypoints, the second included.
void add_leg(const Waypoint& to, double spacing_m, std::vector<Waypoint>& waypoints) {
  const Eigen::Vector2d from_m = waypoints.back().position_m;
  const Eigen::Vector2d offset_m = to.position_m - from_m;
  const int legs = std::max(1, static_cast<int>(std::ceil(offset_m.norm() / spacing_m)));
  for (int i = 1; i < legs; ++i) {
    waypoints.push_back({"towards " + to.name, from_m + static_cast<double>(i) / legs * offset_m});
  }
  waypoints.push_back(to);
}

bool has_room(const geometry::Polygon& outline_m, const Eigen::Vector2d& place_m, double room_m) {
  constexpr double kRoundingM = 1e-9;
  return geometry::contains(outline_m, place_m) &&
         geometry::distance_to_sides_m(outline_m, place_m) >= room_m - kRoundingM;
}

/// A basic string of TOML escapes as JSON does.
std::string quoted(const std::string& text) { return nlohmann::json(text).dump(); }

}  // namespace

WaypointCourse course_around(const geometry::Polygon& outline_m,
                             const geometry::Pose2& T_outline_start,
                             const CourseAroundParams& params) {
  if (outline_m.size() < 3 || !(params.cell_m > 0.0) || !(params.inset_m >= 0.0) ||
      !(params.spacing_m > 0.0) || !(params.margin_m >= 0.0)) {
    throw std::invalid_argument("waypoint course: a parameter is out of range");
  }
  const Box box = box_around(outline_m);
  const Box inner{box.low_m + params.inset_m, box.high_m - params.inset_m};
  if ((inner.low_m >= inner.high_m).any()) {
    throw std::invalid_argument("waypoint course: the room is too small for its corners");
  }
  WaypointCourse course{"around", T_outline_start, {}, params.cell_m, {}, {}};
  const Eigen::Array2d low = ((box.low_m - params.margin_m) / params.cell_m).floor();
  const Eigen::Array2d high = ((box.high_m + params.margin_m) / params.cell_m).floor();
  course.cells = {{static_cast<int>(low.x()), static_cast<int>(low.y())},
                  {static_cast<int>(high.x()), static_cast<int>(high.y())}};
  for (std::size_t i = 0; i < outline_m.size(); ++i) {
    course.known_walls.push_back({outline_m[i], outline_m[(i + 1) % outline_m.size()]});
  }
  const Waypoint start{"start", T_outline_start.position_m()};
  course.waypoints = {start};
  int corner = 0;
  for (const Eigen::Vector2d& corner_m : corners_m(inner, start.position_m)) {
    add_leg({"corner " + std::to_string(++corner), corner_m}, params.spacing_m, course.waypoints);
  }
  add_leg(start, params.spacing_m, course.waypoints);
  course.waypoints.erase(course.waypoints.begin());
  std::erase_if(course.waypoints, [&](const Waypoint& waypoint) {
    return waypoint.position_m != start.position_m &&
           !has_room(outline_m, waypoint.position_m, params.inset_m);
  });
  return course;
}

void write_course(const std::filesystem::path& path, const WaypointCourse& course) {
  const geometry::Pose2& start = course.T_course_start;
  std::string text = fmt::format("name = {}\n\n", quoted(course.name));
  text += fmt::format("[grid]\nx_m = {}\ny_m = {}\ncolumns = {}\nrows = {}\ncell_m = {}\n\n",
                      course.cells.min.x * course.cell_m,
                      course.cells.min.y * course.cell_m,
                      course.cells.columns(),
                      course.cells.rows(),
                      course.cell_m);
  text += fmt::format("[start]\nx_m = {}\ny_m = {}\nheading_deg = {}\n",
                      start.x_m(),
                      start.y_m(),
                      geometry::degrees(start.heading_rad()));
  for (const geometry::Segment& wall : course.known_walls) {
    text += fmt::format("\n[[known_wall]]\npoints_m = [[{}, {}], [{}, {}]]\n",
                        wall.from_m.x(),
                        wall.from_m.y(),
                        wall.to_m.x(),
                        wall.to_m.y());
  }
  for (const Waypoint& waypoint : course.waypoints) {
    text += fmt::format("\n[[waypoint]]\nname = {}\nx_m = {}\ny_m = {}\n",
                        quoted(waypoint.name),
                        waypoint.position_m.x(),
                        waypoint.position_m.y());
  }
  files::write_text_file(path, text);
}

}  // namespace echomap::bench
