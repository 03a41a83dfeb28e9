// SPDX-License-Identifier: MIT
#pragma once

#include "host/geometry/pose2.hpp"
#include "host/slam/odometry_piece.hpp"

namespace echomap::slam {

/// How far a robot has come by its odometry, at one instant.
struct OdometryMark {
  geometry::Pose2 T_odom_robot;
  double path_m = 0.0;      ///< Driven so far, forwards or backwards.
  double turn_rad = 0.0;    ///< Turned so far, to the left; not wrapped.
  double turned_rad = 0.0;  ///< Turned so far, whether to the left or to the right.
  double jumped_m = 0.0;    ///< Jumped so far: carried, or data are missing.
  double jumped_rad = 0.0;
};

/// Whether a step from one instant to the next is too large to be driven.
bool is_jump(const geometry::Pose2& T_before_after);

/// What odometry measured between two marks.
OdometryPiece piece_between(const OdometryMark& before, const OdometryMark& after);

/// Adds up what odometry measures.
class OdometryMeter {
 public:
  /// Takes the next instant. A step that is too large to be driven is a jump.
  void follow(const geometry::Pose2& T_odom_robot);
  /// Somebody has carried the robot to there.
  void carry(const geometry::Pose2& T_odom_robot);

  const OdometryMark& mark() const { return mark_; }

 private:
  void step_to(const geometry::Pose2& T_odom_robot, bool is_carried);

  OdometryMark mark_;
  bool has_begun_ = false;
};

}  // namespace echomap::slam
