// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "host/geometry/pose2.hpp"
#include "host/slam/ekf_slam_filter.hpp"

namespace echomap::slam {

/// How densely a filter stores past poses in its state.
struct PoseHistoryParams {
  /// Spacing of the stored poses, through which later measurements correct the trajectory. Beyond
  /// max_poses every other one is dropped and the spacing doubles.
  double pose_every_m = 1.0;
  double pose_every_rad = 0.5;
  std::size_t max_poses = 100;
};

/// Trajectory of a filter's first robot: each instant is relative to a pose that the filter stores.
class PoseHistory {
 public:
  /// Throws std::invalid_argument for less than two poses kept.
  explicit PoseHistory(const PoseHistoryParams& params = {});

  /// Stores the robot's pose in the filter if the last stored one is far.
  void keep(EkfSlamFilter& filter);
  /// The next instant, when the robot was at `T_now_instant`, from where it was at the last `keep`.
  void add(const geometry::Pose2& T_now_instant);
  /// Where the robot was at each instant, as the filter knows it now.
  std::vector<geometry::Pose2> trajectory(const EkfSlamFilter& filter) const;

 private:
  struct Instant {
    std::size_t stored = 0;
    geometry::Pose2 T_stored_robot;
  };

  void thin_out(EkfSlamFilter& filter);

  PoseHistoryParams params_;
  double pose_every_ = 1.0;  ///< In units of the settings.
  Instant now_;
  std::vector<Instant> instants_;
};

}  // namespace echomap::slam
