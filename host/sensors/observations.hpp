// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "host/geometry/pose2.hpp"
#include "host/sensors/scalar_observation.hpp"
#include "host/sensors/wheel_travel.hpp"
#include "host/sensors/yaw_integrator.hpp"
#include "host/time/robot_time.hpp"

namespace echomap::sensors {

/// One odometry report in SI units.
struct OdometryObservation {
  time::RobotTime stamp;
  WheelTravel travel;
};

/// Where a robot is by odometry of its own, which is not told wheel by wheel.
struct OdometryPoseObservation {
  time::RobotTime stamp;
  geometry::Pose2 T_odom_robot;
};

/// One sonar reading. `range_m` is empty without an echo in range. `pan_rad` is counter-clockwise
/// from straight ahead, in the robot frame.
struct SonarObservation {
  time::RobotTime stamp;
  WheelTravel travel;
  double pan_rad = 0.0;
  std::optional<double> range_m;
  /// False where the sonar did not answer its trigger: it may be dead or not connected.
  bool has_answered = true;
};

/// One round of the infra-red sensors, in the order of the profile. A range is empty where nothing
/// is in reach.
struct InfraredObservation {
  time::RobotTime stamp;
  WheelTravel travel;
  std::vector<std::optional<double>> range_m;
};

/// What the gyro has turned since the session began, bias included.
struct YawObservation {
  time::RobotTime stamp;
  Yaw yaw;
};

/// What touches or threatens the robot. Cliffs stand in the order left, front left, front right,
/// right.
struct HazardObservation {
  time::RobotTime stamp;
  bool bump_left = false;
  bool bump_right = false;
  std::array<bool, 4> cliffs{};
  bool lifted = false;  ///< A wheel hangs: the robot was picked up, and its pose is void.
  bool virtual_wall = false;
  bool wall = false;
  /// From the middle of the robot to its bumper, where a log tells; 0 for that of the profile.
  double bumper_radius_m = 0.0;

  bool is_touching() const { return bump_left || bump_right; }
  /// A wheel hangs, or there is no floor under any of four sensors.
  bool is_in_the_air() const {
    return lifted || std::all_of(cliffs.begin(), cliffs.end(), [](bool is) { return is; });
  }
};

/// Somebody has carried the robot: it is there now, and its wheels go on from `travel`.
struct CarriedObservation {
  time::RobotTime stamp;
  WheelTravel travel;
  geometry::Pose2 T_map_robot;
};

/// Somebody who sees the robot, as an overhead camera, knows where it is at that instant. What is
/// in the map already stays where it is.
struct PoseFixObservation {
  time::RobotTime stamp;
  geometry::Pose2 T_map_robot;
};

/// A landmark that is known by its number, seen from the robot.
struct LandmarkObservation {
  std::int64_t id = 0;
  double range_m = 0.0;
  double bearing_rad = 0.0;
};

/// The battery's voltage.
struct BatteryObservation {
  time::RobotTime stamp;
  double voltage_v = 0.0;
};

/// What each encoder has missed since the session began: edges at which both its pins had changed,
/// each of which is two counts that are lost.
struct EncoderErrorObservation {
  time::RobotTime stamp;
  std::int64_t left = 0;
  std::int64_t right = 0;
};

/// Readings from here to `EndScan` are one scan, whatever turns of the body lie between them.
struct BeginScan {};
struct EndScan {};

/// Whatever a robot senses, and where its scans begin and end.
using Observation = std::variant<OdometryObservation,
                                 SonarObservation,
                                 HazardObservation,
                                 InfraredObservation,
                                 CarriedObservation,
                                 PoseFixObservation,
                                 YawObservation,
                                 BatteryObservation,
                                 EncoderErrorObservation,
                                 ScalarObservation,
                                 BeginScan,
                                 EndScan>;

}  // namespace echomap::sensors
