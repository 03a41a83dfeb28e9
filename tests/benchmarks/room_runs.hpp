// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "hil_mock/world/robot_world.hpp"
#include "host/geometry/angle.hpp"
#include "host/geometry/pose2.hpp"
#include "host/localization/range_table.hpp"
#include "host/localization/range_update.hpp"
#include "host/mapping/raster_map.hpp"

namespace echomap::bench {

/// Of HC-SR04's data sheet; that of the simulated robot is 13 degrees.
inline constexpr localization::RangeTableParams kSonar{geometry::radians(15.0), 4.0};

/// A bundled room as a map of 5 cm cells, right to half a cell.
mapping::RasterMap map_of_room(const std::string& name);

/// A robot with a pan sonar that is put down anywhere in a bundled room, listens, and drives on.
/// The sonar is that of the simulated world. Its drive is kinematic: odometry whose scale and turns
/// are off by half a percent in each run, and that slips as the robot's file says.
class RoomRobot {
 public:
  RoomRobot(const std::string& room, std::uint32_t seed);

  /// Turns to a way that is free, and drives up to 0.4 m.
  void drive();
  /// To somewhere else; the odometry does not notice.
  void be_carried_off();
  /// One ping in each of so many directions, all round.
  std::vector<localization::RangeReading> listen(int directions);

  const geometry::Pose2& T_odom_robot() const { return T_odom_robot_; }
  const geometry::Pose2& T_map_robot() const { return T_map_robot_; }

 private:
  geometry::Pose2 anywhere();
  double normal() { return normal_(random_); }

  std::mt19937 random_;
  std::normal_distribution<double> normal_;
  std::unique_ptr<world::RobotWorld> world_;
  double drive_scale_;
  double turn_scale_;
  geometry::Pose2 T_map_robot_;
  geometry::Pose2 T_odom_robot_;
};

}  // namespace echomap::bench
