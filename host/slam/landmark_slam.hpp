// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "host/models/cut_step_spread.hpp"
#include "host/sensors/range_scan.hpp"
#include "host/slam/ekf_slam_filter.hpp"
#include "host/slam/landmark_extraction.hpp"
#include "host/slam/landmark_graph.hpp"
#include "host/slam/landmark_update.hpp"
#include "host/slam/pose_history.hpp"
#include "host/slam/slam_method.hpp"

namespace echomap::slam {

/// Settings of a LandmarkSlam; the default is for a laser indoors.
struct LandmarkSlamParams {
  EkfSlamFilterParams filter{};
  /// Of the pose at the first scan, by x, y (m) and heading (rad): none where the map begins there.
  Eigen::Matrix3d start_covariance = Eigen::Matrix3d::Zero();
  models::OdometryMotionParams motion{};
  models::WholeStep whole_step{};
  LandmarkExtractionParams extraction{};
  LandmarkUpdateParams update{};
  /// A landmark is removed once beams passed through its place at least min_passes times and by
  /// this share of its sightings.
  double pruned_share = 0.5;
  std::size_t min_passes = 5;
  /// A beam has passed that ends so much farther.
  double pass_margin_m = 0.5;
  PoseHistoryParams pose_history{};
};

/// EKF-SLAM of the paper (Akzhalova and Polichshuk): odometry moves the robot, landmarks are
/// extracted from each scan and associated with those of the map; those that are known correct the
/// state, those that are not are added once they have been seen often enough.
class LandmarkSlam : public SlamMethod {
 public:
  /// Throws std::invalid_argument for invalid parameters.
  explicit LandmarkSlam(const LandmarkSlamParams& params = {});

  void add(const geometry::Pose2& T_odom_robot, const sensors::RangeScan& scan) override;
  localization::PoseGaussian belief() const override { return filter_.belief(); }
  std::vector<geometry::Pose2> trajectory() const override {
    return pose_history_.trajectory(filter_);
  }
  FactorGraph factor_graph() const override { return landmark_graph(filter_); }

  const EkfSlamFilter& filter() const { return filter_; }

 private:
  void move_to(const geometry::Pose2& T_odom_robot);
  void prune(const sensors::RangeScan& scan);

  LandmarkSlamParams params_;
  models::OdometryMotion motion_;
  EkfSlamFilter filter_;
  LandmarkUpdate update_;
  PoseHistory pose_history_;
  std::optional<geometry::Pose2> T_odom_robot_;
};

}  // namespace echomap::slam
