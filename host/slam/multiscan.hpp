// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "host/geometry/pose2.hpp"
#include "host/mapping/wall_echo.hpp"
#include "host/sensors/range_scan.hpp"
#include "host/slam/odometry_piece.hpp"

namespace echomap::slam {

/// How long readings are gathered. Odometry is good over such a stretch.
struct MultiscanParams {
  double max_path_m = 1.0;
  double max_turned_rad = 0.5;
  /// Echoes from farther away are not used: a small error of heading moves them far.
  double max_range_m = 12.0;
  /// A robot that stands hears the same over and over: where there are so many echoes, every other
  /// one is let go, and they are taken half as often.
  std::size_t max_echoes = 4000;
  /// Motion at once that is more than this is a jump.
  double jump_m = 1.0;
  double jump_rad = 1.0;
};

/// Echoes gathered over a stretch of motion (Beevers and Huang 2006), in the frame of the robot
/// where that began.
struct Multiscan {
  geometry::Pose2 T_odom_begin;
  std::vector<mapping::Echo> echoes;
};

/// Gathers scans into multiscans by what was driven and turned.
class MultiscanGathering {
 public:
  /// Throws std::invalid_argument for invalid parameters.
  explicit MultiscanGathering(const MultiscanParams& params);

  /// Takes the odometry between two scans: without it, a long way from one to the next is a jump.
  void follow(const geometry::Pose2& T_odom_robot);
  /// The same, and however short the step is, it is a jump.
  void carry(const geometry::Pose2& T_odom_robot);
  /// Takes the next scan. If it is the first of a new multiscan, answers the odometry's piece from
  /// the begin of the last one to the begin of the new one; `finished` is then the last one.
  std::optional<OdometryPiece> add(const geometry::Pose2& T_odom_robot,
                                   const sensors::RangeScan& scan);

  bool has_begun() const { return T_odom_last_.has_value(); }
  /// What is being gathered.
  const Multiscan& open() const { return open_; }
  /// What was gathered before that.
  const Multiscan& finished() const { return finished_; }
  /// From the begin of what is being gathered to the last scan.
  const OdometryPiece& piece() const { return piece_; }

 private:
  void step_to(const geometry::Pose2& T_odom_robot, bool is_carried);
  void gather(const sensors::RangeScan& scan);
  void thin_out();

  MultiscanParams params_;
  std::optional<geometry::Pose2> T_odom_last_;
  Multiscan open_;
  std::size_t taken_every_ = 1;
  std::size_t answers_ = 0;  ///< Since what is being gathered began.
  Multiscan finished_;
  OdometryPiece piece_;
};

}  // namespace echomap::slam
