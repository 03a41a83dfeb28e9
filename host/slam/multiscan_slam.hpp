// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "host/slam/multiscan.hpp"
#include "host/slam/multiscan_alignment.hpp"
#include "host/slam/patch_matching.hpp"
#include "host/slam/scan_map.hpp"
#include "host/slam/slam_method.hpp"
#include "host/slam/surface_patch.hpp"

namespace echomap::slam {

/// One setting for sonars, infra-red and thin lasers.
struct MultiscanSlamParams {
  MultiscanParams gathering;
  SurfacePatchParams patches;
  PatchMatchingParams matching;
  MultiscanAlignmentParams alignment;
  /// So many multiscans move when a new one comes; now and then all do.
  std::size_t window = 30;
  /// All move when there are by this share more than when all moved last.
  double whole_share = 0.025;
  /// Steps of matching and aligning, each time.
  int steps = 2;
  /// The odometry may turn out to be so much better or worse than `alignment.odometry` says.
  double least_odometry_scale = 0.33;
  double most_odometry_scale = 3.0;
  ScanMapParams map;
};

/// SLAM for sensors that see too little at once to be matched scan by scan
/// (docs/algorithms/multiscan_slam.md).
class MultiscanSlam final : public SlamMethod {
 public:
  /// Throws std::invalid_argument for parameters without sense.
  explicit MultiscanSlam(const MultiscanSlamParams& params = {});

  void follow(const geometry::Pose2& T_odom_robot) override;
  void add(const geometry::Pose2& T_odom_robot, const RangeScan& scan) override;
  localization::PoseGaussian belief() const override;
  std::vector<geometry::Pose2> trajectory() const override;
  mapping::OccupancyGrid grid() const override;
  FactorGraph factor_graph() const override;

  /// How odometry is off, as far as is known.
  const OdometryCalibration& calibration() const { return graph_.calibration; }
  /// What is estimated, for looking into.
  const MultiscanGraph& graph() const { return graph_; }

 private:
  struct TakenScan {
    std::size_t multiscan = 0;
    geometry::Pose2 T_begin_robot;
    RangeScan scan;
  };

  void begin_multiscan(const OdometryPiece& piece);
  /// Of the newest multiscans, which move with each new one.
  std::size_t first_of_window() const;
  /// Aligns the newest multiscans, or all of them.
  void align();
  AlignmentStep align_from(std::size_t first_free, std::size_t first_wide);
  /// Takes the odometry's scale under which all measurements are the least surprising (empirical
  /// Bayes). So good odometry is hardly bent by echoes that are only a little off.
  void learn_odometry_scale(const std::vector<PatchMatch>& matches, std::size_t first_wide);
  /// Of the robot after it has gone on from the newest multiscan.
  Eigen::Matrix3d covariance_after(const OdometryPiece& piece) const;
  /// Where the robot was, from the multiscan's begin, by odometry without its steady errors.
  geometry::Pose2 T_map_robot(const TakenScan& taken) const;

  MultiscanSlamParams params_;
  MultiscanGathering gathering_;
  bool has_begun_ = false;
  MultiscanGraph graph_;
  std::vector<TakenScan> scans_;
  std::size_t aligned_whole_ = 0;  ///< Multiscans when all moved last.
};

}  // namespace echomap::slam
