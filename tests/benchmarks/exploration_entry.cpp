// SPDX-License-Identifier: MIT
#include "tests/benchmarks/exploration_entry.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>

#include "hil_mock/world/floor_plan_file.hpp"
#include "host/exploration/tangent_bug.hpp"
#include "host/files/bundled_files.hpp"
#include "host/mapping/cell_field.hpp"
#include "host/session/robot_profile.hpp"
#include "tests/benchmarks/course_around.hpp"

namespace echomap::bench {
namespace {

using geometry::CellIndex;
using mapping::CellField;

constexpr double kCellM = 0.02;
/// A robot that cannot pass over so much of the floor is too large for the room.
constexpr double kMinShare = 0.75;
/// More floor than this takes sensors that see 6 cm far hours.
constexpr double kMaxInfraredFloorM2 = 1.0;
/// Between a hull at a waypoint and what stands there.
constexpr double kSpareM = 0.02;

/// Cells around a room: how far their middle is from the nearest wall, 0 where it is not free.
CellField clearances_m(const world::FloorPlan& room) {
  Eigen::Array2d low_m = room.room_m().front();
  Eigen::Array2d high_m = low_m;
  for (const Eigen::Vector2d& corner_m : room.room_m()) {
    low_m = low_m.min(corner_m.array());
    high_m = high_m.max(corner_m.array());
  }
  const Eigen::Array2i low = (low_m / kCellM).floor().cast<int>();
  const Eigen::Array2i high = (high_m / kCellM).floor().cast<int>();
  CellField field({{low.x(), low.y()}, {high.x(), high.y()}}, kCellM);
  for (std::size_t i = 0; i < field.size(); ++i) {
    const Eigen::Vector2d middle_m = field.center_m(field.cell(i));
    field[i] = room.is_free(middle_m) ? static_cast<float>(room.clearance_m(middle_m)) : 0.0F;
  }
  return field;
}

/// Where the middle of a hull can get to.
std::vector<CellIndex> cells_in_reach(const CellField& clearances_m,
                                      CellIndex start,
                                      double radius_m) {
  CellField seen(clearances_m.bounds(), clearances_m.resolution_m());
  std::vector<CellIndex> found;
  std::vector<CellIndex> ahead{start};
  while (!ahead.empty()) {
    const CellIndex cell = ahead.back();
    ahead.pop_back();
    const bool is_new = seen.holds(cell) && seen[seen.index(cell)] == 0.0F &&
                        clearances_m[clearances_m.index(cell)] >= radius_m;
    if (!is_new) {
      continue;
    }
    seen[seen.index(cell)] = 1.0F;
    found.push_back(cell);
    for (const CellIndex step : std::array<CellIndex, 4>{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}}) {
      ahead.push_back({cell.x + step.x, cell.y + step.y});
    }
  }
  return found;
}

/// Marks what lies under a hull whose middle is on a cell.
void pass_over(CellIndex middle, double radius_m, CellField& passed) {
  const int reach = static_cast<int>(std::floor(radius_m / kCellM));
  for (int y = -reach; y <= reach; ++y) {
    for (int x = -reach; x <= reach; ++x) {
      if (std::hypot(x, y) * kCellM <= radius_m) {
        passed[passed.index({middle.x + x, middle.y + y})] = 1.0F;
      }
    }
  }
}

double free_m2(const CellField& clearances_m) {
  double area_m2 = 0.0;
  for (std::size_t i = 0; i < clearances_m.size(); ++i) {
    area_m2 += clearances_m[i] > 0.0F ? kCellM * kCellM : 0.0;
  }
  return area_m2;
}

/// What a strategy that goes by a sonar drives, and the others.
std::string robot_for(const std::string& strategy) {
  if (strategy == "coastal" || strategy == "random-bounce") {
    return "create";
  }
  return strategy == "epuck" ? "epuck" : "uno_2wd";
}

world::FloorPlan load_room(const std::string& name_or_file) {
  return world::read_floor_plan(files::TomlReader::load(
      files::bundled_file(name_or_file, "hil_mock/worlds", "world (--rooms)")));
}

/// Why a robot of that size has no business in a room; empty where it fits.
std::string misfit_of(const world::FloorPlan& room,
                      const ExplorationCase& what,
                      double body_radius_m) {
  const double share = share_in_reach(room, body_radius_m);
  if (share < kMinShare) {
    return fmt::format("{} passes over {:.0f} % of its floor", what.robot, 100.0 * share);
  }
  const double floor_m2 = free_m2(clearances_m(room));
  if (what.strategy == "epuck" && floor_m2 > kMaxInfraredFloorM2) {
    return fmt::format("{:.1f} m2 are too much for sensors that see 6 cm far", floor_m2);
  }
  return "";
}

/// Writes the course of a room; answers why it has none.
std::string put_course(const world::FloorPlan& room,
                       double body_radius_m,
                       const std::filesystem::path& path) {
  const double reached_m = exploration::TangentBugParams().reached_m;
  try {
    const auto course = course_of(room, body_radius_m);
    const Eigen::Vector2d start_m = course.T_course_start.position_m();
    const bool leads_on =
        std::any_of(course.waypoints.begin(), course.waypoints.end(), [&](const auto& waypoint) {
          return (waypoint.position_m - start_m).norm() > reached_m;
        });
    write_course(path, course);
    return leads_on ? "" : "all of its places count as reached from the start";
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

}  // namespace

double share_in_reach(const world::FloorPlan& room, double body_radius_m) {
  const CellField clear_m = clearances_m(room);
  CellField passed(clear_m.bounds(), kCellM);
  const CellIndex start = clear_m.cell_at(room.T_world_start().position_m());
  for (const CellIndex cell : cells_in_reach(clear_m, start, body_radius_m)) {
    pass_over(cell, body_radius_m, passed);
  }
  return free_m2(passed) / free_m2(clear_m);
}

exploration::WaypointCourse course_of(const world::FloorPlan& room, double body_radius_m) {
  auto course = course_around(room.room_m(), room.T_world_start());
  const Eigen::Vector2d start_m = room.T_world_start().position_m();
  std::erase_if(course.waypoints, [&](const exploration::Waypoint& waypoint) {
    const bool has_room = room.is_free(waypoint.position_m) &&
                          room.clearance_m(waypoint.position_m) >= body_radius_m + kSpareM;
    return !has_room && waypoint.position_m != start_m;
  });
  return course;
}

ExplorationEntry entry_of(const std::string& room,
                          const std::string& strategy,
                          const std::filesystem::path& folder) {
  const world::FloorPlan plan = load_room(room);
  ExplorationEntry entry{{room, strategy, robot_for(strategy)}};
  const mapping::CellBounds bounds = clearances_m(plan).bounds();
  entry.room_edge_m = kCellM * std::max(bounds.columns(), bounds.rows());
  entry.what.under_camera = strategy == "epuck";
  const double radius_m = session::load_robot_profile(entry.what.robot).body_radius_m;
  entry.why_not = misfit_of(plan, entry.what, radius_m);
  if (strategy == "tangent-bug" && entry.why_not.empty()) {
    entry.what.course = folder / (plan.name() + ".toml");
    entry.why_not = put_course(plan, radius_m, entry.what.course);
  }
  return entry;
}

}  // namespace echomap::bench
