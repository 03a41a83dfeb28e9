// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "hil_mock/world/floor_plan.hpp"
#include "hil_mock/world/noise.hpp"
#include "hil_mock/world/robot_params.hpp"
#include "host/geometry/pose2.hpp"
#include "host/models/contact_likelihood.hpp"

namespace echomap::papers {

/// The body of hil_mock/robots/create.toml.
world::RobotParams create_robot();

/// Odometry errors of one simulated Create in one run: constant scales of drives and turns, and
/// slip that grows with the distance.
class WheelErrors {
 public:
  WheelErrors(const world::DriveParams& drive, world::NoiseStream& noise);

  /// Motion that the odometry measures for a turn on the spot and then a drive.
  geometry::Pose2 measured(double turn_rad, double drive_m);

 private:
  const world::DriveParams& drive_;
  world::NoiseStream& noise_;
  double drive_scale_;
  double turn_scale_;
  double bend_rad_per_m_;
};

/// A Create that drives straight on until it bumps, turns by a random angle and drives on
/// (Mukherjee et al., section V: "moves in a random manner").
class BounceRobot {
 public:
  /// Places the robot anywhere in the room, which must outlive this.
  BounceRobot(const world::FloorPlan& room, std::uint32_t seed);

  /// Drives on by up to `max_m`, or turns where it has bumped.
  void step(double max_m);
  /// Readings of its contacts where it is.
  models::ContactReading contacts() const;
  /// Moves it to somewhere else; the odometry does not notice.
  void be_carried_off();

  const geometry::Pose2& T_world_robot() const { return T_world_robot_; }
  const geometry::Pose2& T_odom_robot() const { return T_odom_robot_; }
  int bumps() const { return bumps_; }

 private:
  bool touches() const;

  const world::FloorPlan& room_;
  world::RobotParams robot_ = create_robot();
  world::NoiseStream noise_;
  WheelErrors errors_;
  geometry::Pose2 T_world_robot_;
  geometry::Pose2 T_odom_robot_;
  int bumps_ = 0;
};

}  // namespace echomap::papers
