// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <variant>

#include <Eigen/Core>

#include "host/geometry/pose2.hpp"

namespace echomap::session {

/// Wheels to zero at once; nothing moves until somebody says so.
struct StopRobot {
  enum class Cause : unsigned char { kPressed, kDriverGone, kDriverSilent };
  Cause cause = Cause::kPressed;
};
/// Steers for 250 ms, as shares of the robot's speeds from -1 to 1; counter-clockwise positive.
struct SteerRobot {
  double forward = 0.0;
  double turn = 0.0;
  /// When it came.
  std::chrono::steady_clock::time_point at{};

  bool moves() const { return forward != 0.0 || turn != 0.0; }
};
/// The strategy drives on.
struct ResumeStrategy {};
/// Drives there over known floor, then stops.
struct GoTo {
  Eigen::Vector2d at_m = Eigen::Vector2d::Zero();
};
/// Somebody has moved the robot: it may be anywhere.
struct ReportMoved {};
/// The robot is about there.
struct PlaceRobot {
  geometry::Pose2 T_map_robot;
};
/// Of a simulated robot: times real time; 0: as fast as it can.
struct SetSpeed {
  double factor = 0.0;
};
/// Of a simulated robot: somebody takes it somewhere else.
struct CarryOff {};
/// Of a simulated robot: somebody puts a box there.
struct PutBox {
  Eigen::Vector2d at_m = Eigen::Vector2d::Zero();
};
/// Of a simulated robot: no byte passes for so long.
struct CutCable {
  double for_s = 0.0;
};

/// What a person asks of a robot that runs.
using OperatorCommand = std::variant<StopRobot,
                                     SteerRobot,
                                     ResumeStrategy,
                                     GoTo,
                                     ReportMoved,
                                     PlaceRobot,
                                     SetSpeed,
                                     CarryOff,
                                     PutBox,
                                     CutCable>;

}  // namespace echomap::session
