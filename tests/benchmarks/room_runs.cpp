// SPDX-License-Identifier: MIT
#include "tests/benchmarks/room_runs.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "hil_mock/world/floor_plan_file.hpp"
#include "hil_mock/world/robot_file.hpp"
#include "host/files/bundled_files.hpp"
#include "host/files/toml_reader.hpp"

namespace echomap::bench {
namespace {

using geometry::Pose2;

constexpr double kCellM = 0.05;
/// A robot keeps so far from walls.
constexpr double kClearanceM = 0.15;

world::FloorPlan plan_of(const std::string& room) {
  return world::read_floor_plan(
      files::TomlReader::load(files::bundled_file(room, "hil_mock/worlds", "world")));
}

world::RobotParams robot() {
  return world::read_robot(
      files::TomlReader::load(files::bundled_file("uno_2wd", "hil_mock/robots", "robot")));
}

struct Box {
  Eigen::Vector2d low;
  Eigen::Vector2d high;
};

Box box_around(const geometry::Polygon& corners_m) {
  Box box{corners_m.front(), corners_m.front()};
  for (const Eigen::Vector2d& corner_m : corners_m) {
    box.low = box.low.cwiseMin(corner_m);
    box.high = box.high.cwiseMax(corner_m);
  }
  return box;
}

bool is_clear(const world::FloorPlan& plan, const Eigen::Vector2d& point_m) {
  return plan.is_free(point_m) && plan.clearance_m(point_m) > kClearanceM;
}

}  // namespace

mapping::RasterMap map_of_room(const std::string& name) {
  const world::FloorPlan plan = plan_of(name);
  const Box box = box_around(plan.room_m());
  const Eigen::Vector2d origin_m = box.low.array() - 2.0 * kCellM;
  const Eigen::Vector2d cells = (box.high - origin_m) / kCellM;
  mapping::RasterMap map(static_cast<int>(std::ceil(cells.x())) + 2,
                         static_cast<int>(std::ceil(cells.y())) + 2,
                         kCellM,
                         origin_m);
  for (int y = 0; y < map.rows(); ++y) {
    for (int x = 0; x < map.columns(); ++x) {
      const Eigen::Vector2d middle_m = map.center_m({x, y});
      if (plan.is_free(middle_m)) {
        map.set({x, y}, mapping::CellState::kFree);
      } else if (plan.clearance_m(middle_m) <= kCellM) {
        map.set({x, y}, mapping::CellState::kOccupied);
      }
    }
  }
  return map;
}

RoomRobot::RoomRobot(const std::string& room, std::uint32_t seed)
    : random_(seed),
      world_(std::make_unique<world::RobotWorld>(plan_of(room), robot(), seed)),
      drive_scale_(1.0 + 0.005 * normal()),
      turn_scale_(1.0 + 0.005 * normal()),
      T_map_robot_(anywhere()) {}

Pose2 RoomRobot::anywhere() {
  const Box box = box_around(world_->plan().room_m());
  std::uniform_real_distribution<double> share(0.0, 1.0);
  while (true) {
    const Eigen::Vector2d point_m(box.low.x() + share(random_) * (box.high - box.low).x(),
                                  box.low.y() + share(random_) * (box.high - box.low).y());
    const double heading_rad = (2.0 * share(random_) - 1.0) * std::numbers::pi;
    if (is_clear(world_->plan(), point_m)) {
      return {point_m.x(), point_m.y(), heading_rad};
    }
  }
}

void RoomRobot::be_carried_off() { T_map_robot_ = anywhere(); }

void RoomRobot::drive() {
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  double turn_rad = 0.0;
  double travelled_m = 0.0;
  for (int tries = 0; tries < 20 && travelled_m < 0.1; ++tries) {
    turn_rad = share(random_) * std::numbers::pi;
    const Pose2 T_map_turned = T_map_robot_ * Pose2(0.0, 0.0, turn_rad);
    travelled_m = 0.0;
    while (travelled_m < 0.4 &&
           is_clear(world_->plan(), T_map_turned * Eigen::Vector2d(travelled_m + 0.02, 0.0))) {
      travelled_m += 0.02;
    }
  }
  const double slip_m = world_->robot().drive.slip_m_per_sqrt_m * std::sqrt(std::abs(travelled_m));
  const double slip_rad = slip_m / world_->robot().drive.track_m * normal();
  T_map_robot_ = T_map_robot_ * Pose2(0.0, 0.0, turn_rad) * Pose2(travelled_m, 0.0, slip_rad);
  T_odom_robot_ = T_odom_robot_ * Pose2(0.0, 0.0, turn_rad * turn_scale_ + 0.005 * normal()) *
                  Pose2(travelled_m * drive_scale_ + slip_m * normal(), 0.0, 0.0);
}

std::vector<localization::RangeReading> RoomRobot::listen(int directions) {
  std::vector<localization::RangeReading> readings;
  const Pose2 T_robot_sonar(world_->robot().sonar.mount_x_m, world_->robot().sonar.mount_y_m, 0.0);
  for (int i = 0; i < directions; ++i) {
    const double bearing_rad = 2.0 * std::numbers::pi * i / directions;
    const Pose2 T_robot_turned(0.0, 0.0, bearing_rad);  // It turns on the spot to look.
    world_->place(T_map_robot_ * T_robot_turned);
    readings.push_back({T_robot_turned * T_robot_sonar, std::nullopt});
    if (const auto flight_s = world_->ping(0.0)) {
      readings.back().range_m = *flight_s * world_->robot().sonar.speed_of_sound_m_per_s / 2.0;
    }
  }
  return readings;
}

}  // namespace echomap::bench
