// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "host/geometry/pose2.hpp"
#include "host/slam/odometry_meter.hpp"
#include "host/slam/odometry_piece.hpp"
#include "host/team_map/submap.hpp"

namespace echomap::team_map {

/// Submaps of one robot with the turns of their odometry calibrated by its first stop
/// (slam::turn_share): without that, stops of several headings are distorted. A submap never
/// changes, so each is calibrated once, and the share of a turn is estimated once.
class CalibratedSubmaps {
 public:
  /// Takes all submaps that the robot has published so far, and calibrates the new ones. Starts
  /// again where there are fewer than before.
  void take(const std::vector<Submap>& submaps);

  const std::vector<Submap>& submaps() const { return submaps_; }

 private:
  void begin(const Submap& first);
  void add(Submap submap);

  std::vector<Submap> submaps_;
  /// Empty where the first stop does not calibrate turns.
  std::optional<slam::OdometryCalibration> calibration_;
  /// Pose of the last reading by the robot's odometry, and by the calibrated one.
  slam::OdometryMark reported_mark_;
  geometry::Pose2 T_odom_robot_;
};

}  // namespace echomap::team_map
