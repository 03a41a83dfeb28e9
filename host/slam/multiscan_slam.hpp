// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "host/sensors/range_scan.hpp"
#include "host/slam/multiscan.hpp"
#include "host/slam/multiscan_alignment.hpp"
#include "host/slam/patch_matching.hpp"
#include "host/slam/slam_method.hpp"
#include "host/slam/surface_patch.hpp"

namespace echomap::slam {

/// A hypothesis of how accurate the odometry is: factors on the deviations of
/// MultiscanAlignmentParams.
struct OdometryNoiseHypothesis {
  double steady_scale = 1.0;  ///< Scale of the systematic deviations.
  /// Bounds of the scale of the random deviations, which is learnt.
  double min_scale = 0.33;
  double max_scale = 3.0;
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
  /// All hypotheses are tracked; the one with the least negative log evidence is reported. One for
  /// accurate odometry, one for poor odometry.
  std::vector<OdometryNoiseHypothesis> noise_hypotheses{{}, {0.25, 0.2, 0.2}};
  /// Weight of a match when hypotheses are compared; larger than in the alignment, because errors
  /// that matches share are alike in all hypotheses.
  double belief_match_weight = 0.3;
};

/// SLAM for sensors that see too little at once to be matched scan by scan
/// (docs/algorithms/multiscan_slam.md).
class MultiscanSlam final : public SlamMethod {
 public:
  /// Throws std::invalid_argument for invalid parameters.
  explicit MultiscanSlam(const MultiscanSlamParams& params = {});

  void follow(const geometry::Pose2& T_odom_robot) override;
  void carry(const geometry::Pose2& T_odom_robot) override;
  void add(const geometry::Pose2& T_odom_robot, const sensors::RangeScan& scan) override;
  localization::PoseGaussian belief() const override;
  std::vector<geometry::Pose2> trajectory() const override;
  FactorGraph factor_graph() const override;

  /// Estimated systematic errors of the odometry.
  const OdometryCalibration& calibration() const { return graph().calibration; }
  /// The graph of the best hypothesis, for inspection.
  const MultiscanGraph& graph() const { return graphs_[best_]; }

 private:
  struct TakenScan {
    std::size_t multiscan = 0;
    geometry::Pose2 T_begin_robot;
  };

  void begin_once(const geometry::Pose2& T_odom_robot);
  void begin_multiscan(const OdometryPiece& piece);
  /// Of the newest multiscans, which move with each new one.
  std::size_t first_of_window() const;
  /// Aligns the newest multiscans, or all of them and selects the hypothesis again.
  void align();
  void align_whole();
  /// Takes the odometry's scale under which all measurements are the least surprising (empirical
  /// Bayes). So good odometry is hardly bent by echoes that are only a little off.
  void learn_odometry_scale(const OdometryNoiseHypothesis& hypothesis,
                            const std::vector<PatchMatch>& matches,
                            MultiscanGraph& graph) const;
  /// Of all that was measured. Nothing is matched farther than surfaces are off: who hopes for
  /// matches from far away shall not be paid for finding some.
  double negative_log_evidence_of(MultiscanGraph graph) const;
  /// Of the robot after it has gone on from the newest multiscan.
  Eigen::Matrix3d covariance_after(const MultiscanGraph& graph, const OdometryPiece& piece) const;
  /// Where the robot was, from the multiscan's begin, by odometry.
  geometry::Pose2 T_map_robot(const TakenScan& taken) const;

  MultiscanSlamParams params_;
  MultiscanGathering gathering_;
  std::vector<MultiscanGraph> graphs_;  ///< One graph per hypothesis.
  std::size_t best_ = 0;          ///< Index of the hypothesis with the least negative log evidence.
  std::vector<TakenScan> taken_;  ///< One of each scan.
  std::size_t aligned_whole_ = 0;  ///< Multiscans when all moved last.
};

}  // namespace echomap::slam
