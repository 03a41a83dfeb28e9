// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "host/geometry/pose2.hpp"
#include "host/sensors/range_scan.hpp"

namespace echomap::slam {

/// When scans are enough to be matched.
struct ScanGatheringParams {
  /// Farther answers are left out, metres: lasers of buildings reach 80 m.
  double max_range_m = 100.0;
  /// Points nearer to the one before say nothing new and are left out, metres.
  double spacing_m = 0.03;
  /// Scans are gathered until they have so many points together. A full laser has them at once;
  /// twelve beams take eight scans.
  std::size_t min_points = 80;
  /// But over no longer way, metres: odometry has to hold the points together.
  double max_distance_m = 2.0;
  /// And no more of them, where nothing answers and the robot stands.
  std::size_t max_scans = 40;
};

/// A scan, and where the odometry had the robot then.
struct GatheredScan {
  geometry::Pose2 T_odom_robot;
  sensors::RangeScan scan;
};

/// Gathers scans over a stretch of motion, held together by odometry, until they have points enough
/// to be matched as one (multiscans: Beevers and Huang 2006).
class ScanGathering {
 public:
  /// Throws std::invalid_argument for invalid parameters.
  explicit ScanGathering(const ScanGatheringParams& params = {});

  void add(const geometry::Pose2& T_odom_robot, const sensors::RangeScan& scan);
  bool is_enough() const;
  /// All points in the frame of the robot at the last scan.
  std::vector<Eigen::Vector2d> points_m() const;
  const std::vector<GatheredScan>& scans() const { return scans_; }
  void clear();

 private:
  ScanGatheringParams params_;
  std::vector<GatheredScan> scans_;
  std::vector<std::vector<Eigen::Vector2d>> points_m_;  ///< Of each scan, in its robot's frame.
  std::size_t count_ = 0;
  double travelled_m_ = 0.0;
};

}  // namespace echomap::slam
