// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "host/geometry/pose2.hpp"
#include "host/slam/odometry_meter.hpp"
#include "host/slam/odometry_piece.hpp"
#include "host/team_map/submap.hpp"

namespace echomap::team_map {

/// Submaps of one robot with all turns of the odometry as its first stop calibrates them
/// (slam::turn_share): else stops of several headings are bent. A submap never changes, so each is
/// calibrated once, and the share of a turn is estimated once.
class CalibratedSubmaps {
 public:
  /// Takes all that the robot has told so far; what was taken before is not calibrated again.
  /// Starts again with fewer submaps than before.
  void take(const std::vector<Submap>& submaps);

  const std::vector<Submap>& submaps() const { return submaps_; }

 private:
  void begin(const Submap& first);
  void add(Submap submap);

  std::vector<Submap> submaps_;
  /// Empty where the first stop does not calibrate turns.
  std::optional<slam::OdometryCalibration> calibration_;
  /// Of the last reading: what the robot told, and where it was by calibrated odometry.
  slam::OdometryMark told_;
  geometry::Pose2 T_odom_robot_;
};

}  // namespace echomap::team_map
