// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "host/sensors/range_scan.hpp"
#include "host/slam/multiscan.hpp"
#include "host/slam/multiscan_alignment.hpp"
#include "host/slam/patch_matching.hpp"
#include "host/slam/scan_map.hpp"
#include "host/slam/slam_method.hpp"
#include "host/slam/surface_patch.hpp"

namespace echomap::slam {

/// How good the odometry may be: factors of the deviations that MultiscanAlignmentParams says.
struct OdometryBelief {
  double steady_scale = 1.0;  ///< Of what is off all the time.
  /// Of what is off by chance: learnt between these.
  double least_scale = 0.33;
  double most_scale = 3.0;
};

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
  /// Each is followed all the time; what surprises least is believed. Good odometry is hardly bent,
  /// and poor odometry is not trusted for long.
  std::vector<OdometryBelief> beliefs{{}, {0.25, 0.2, 0.2}};
  /// What a match counts where beliefs are compared; more than in the alignment: what matches share
  /// is much the same in both, and does not tell them apart.
  double belief_match_weight = 0.3;
  ScanMapParams map;
};

/// SLAM for sensors that see too little at once to be matched scan by scan
/// (docs/algorithms/multiscan_slam.md).
class MultiscanSlam final : public SlamMethod {
 public:
  /// Throws std::invalid_argument for parameters without sense.
  explicit MultiscanSlam(const MultiscanSlamParams& params = {});

  void follow(const geometry::Pose2& T_odom_robot) override;
  void carry(const geometry::Pose2& T_odom_robot) override;
  void add(const geometry::Pose2& T_odom_robot, const sensors::RangeScan& scan) override;
  localization::PoseGaussian belief() const override;
  std::vector<geometry::Pose2> trajectory() const override;
  mapping::OccupancyGrid grid() const override;
  FactorGraph factor_graph() const override;

  /// How odometry is off, as far as is known.
  const OdometryCalibration& calibration() const { return graph().calibration; }
  /// What is estimated under the belief that surprises least, for looking into.
  const MultiscanGraph& graph() const { return graphs_[best_]; }

 private:
  struct TakenScan {
    std::size_t multiscan = 0;
    geometry::Pose2 T_begin_robot;
    sensors::RangeScan scan;
  };

  void begin_once(const geometry::Pose2& T_odom_robot);
  void begin_multiscan(const OdometryPiece& piece);
  /// Of the newest multiscans, which move with each new one.
  std::size_t first_of_window() const;
  /// Aligns the newest multiscans, or all of them and chooses the belief anew.
  void align();
  void align_whole();
  /// Takes the odometry's scale under which all measurements are the least surprising (empirical
  /// Bayes). So good odometry is hardly bent by echoes that are only a little off.
  void learn_odometry_scale(const OdometryBelief& belief,
                            const std::vector<PatchMatch>& matches,
                            MultiscanGraph& graph) const;
  /// Of all that was measured. Nothing is matched farther than surfaces are off: who hopes for
  /// matches from far away shall not be paid for finding some.
  double surprise_of(MultiscanGraph graph) const;
  /// Of the robot after it has gone on from the newest multiscan.
  Eigen::Matrix3d covariance_after(const MultiscanGraph& graph, const OdometryPiece& piece) const;
  /// Where the robot was, from the multiscan's begin, by odometry.
  geometry::Pose2 T_map_robot(const TakenScan& taken) const;

  MultiscanSlamParams params_;
  MultiscanGathering gathering_;
  bool has_begun_ = false;
  std::vector<MultiscanGraph> graphs_;  ///< One for each belief.
  std::size_t best_ = 0;                ///< Of the beliefs, that which surprises least.
  std::vector<TakenScan> scans_;
  std::size_t aligned_whole_ = 0;  ///< Multiscans when all moved last.
};

}  // namespace echomap::slam
