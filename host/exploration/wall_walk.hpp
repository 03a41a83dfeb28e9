// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "host/geometry/pose2.hpp"
#include "host/localization/odometry_correction.hpp"

namespace echomap::exploration {

/// What a robot feels of the walls.
struct WallContact {
  bool bumped = false;
  bool wall_ahead = false;        ///< It sees a virtual wall, as that of its own emitter.
  bool wall_beside = false;       ///< Its wall sensor sees one.
  std::optional<double> range_m;  ///< That sensor's measure of how far.
};

/// One tick of a walk along a wall.
struct WallStep {
  geometry::Pose2 T_map_robot;
  WallContact contact;
  /// Since the walk began: the way, and the turns, whole ones counted, counter-clockwise positive.
  double travelled_m = 0.0;
  double turned_rad = 0.0;
};

/// Where a robot has been, tick by tick, by its corrected odometry (Mukherjee et al., equations 6
/// to 8).
class WallWalk {
 public:
  explicit WallWalk(const localization::DistanceCorrection& correction) : correction_(correction) {}

  /// The odometry goes on, from one call to the next; the first one is where the map begins.
  void follow(const geometry::Pose2& T_odom_robot);
  const geometry::Pose2& T_map_robot() const { return T_map_robot_; }

  /// A walk begins here; what was before is forgotten.
  void begin();
  /// Of a walk that has begun.
  const WallStep& add(const WallContact& contact);
  const std::vector<WallStep>& steps() const { return steps_; }

 private:
  localization::DistanceCorrection correction_;
  std::optional<geometry::Pose2> T_odom_robot_;
  geometry::Pose2 T_map_robot_;
  double travelled_m_ = 0.0;
  double turned_rad_ = 0.0;
  std::vector<WallStep> steps_;
};

/// A place on a wall, how far along the walk it was seen, and where to the robot went there.
struct WallPoint {
  Eigen::Vector2d place_m = Eigen::Vector2d::Zero();
  double travelled_m = 0.0;
  double heading_rad = 0.0;
};

/// What the wall sensor has measured while the robot went along walls.
std::vector<WallPoint> wall_points(const std::vector<WallStep>& steps,
                                   const geometry::Pose2& T_robot_sensor);

}  // namespace echomap::exploration
