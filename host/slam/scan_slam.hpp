// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "host/models/odometry_motion.hpp"
#include "host/sensors/range_scan.hpp"
#include "host/slam/key_frames.hpp"
#include "host/slam/loop_closing.hpp"
#include "host/slam/scan_gathering.hpp"
#include "host/slam/scan_matching.hpp"
#include "host/slam/slam_method.hpp"
#include "host/slam/surface_field.hpp"

namespace echomap::slam {

/// How ScanSlam works.
struct ScanSlamParams {
  ScanGatheringParams gathering;
  SurfaceFieldParams field;
  ScanMatchingParams matching;
  PoseGraphParams graph;
  LoopSearchParams search;
  LoopClosingParams loops;
  /// How far odometry may be off: three times the default of a good base, since what it is off by
  /// is not known of a log.
  models::OdometryMotionParams motion{0.01, 0.0025, 0.0025, 1e-3, 1e-3};
  /// Of every step, metres and radians: odometry is rounded, and scans are not taken at its
  /// instant.
  double min_spread_m = 0.01;
  double min_spread_rad = 0.01;
  /// A key frame is begun where the robot is farther than this, or turned by more, from each
  /// around.
  double key_frame_m = 0.5;
  double key_frame_rad = 0.5;
  /// Or after such a share of them where fewer points than this lie on what is known.
  double new_ground_scale = 0.3;
  double new_ground_share = 0.75;
  /// The way between two key frames may be off by so much that the match does not tell.
  double frame_spread_m = 0.01;
  double frame_spread_rad = 0.003;
  /// A scan is matched to the key frames within such a way along the graph, metres.
  double local_distance_m = 12.0;
  /// After so long a way the map around the robot is gathered anew, metres.
  double renewal_distance_m = 4.0;
  bool closes_loops = true;
};

/// SLAM by matching scans to the surfaces that were seen around: each scan is put where it lies on
/// them, with odometry as a prior; key frames are kept as nodes of a pose graph, as many as the
/// ground that was seen takes; where the robot is back at a place, an edge closes the loop; the map
/// is what the key frames have seen from their corrected poses. Scans with few beams are gathered
/// first. For lasers, dense and thin.
class ScanSlam : public SlamMethod {
 public:
  /// Throws std::invalid_argument for invalid parameters.
  explicit ScanSlam(const ScanSlamParams& params = {});

  void add(const geometry::Pose2& T_odom_robot, const sensors::RangeScan& scan) override;
  /// The covariance is that of the pose against the map around it.
  localization::PoseGaussian belief() const override { return belief_; }
  std::vector<geometry::Pose2> trajectory() const override;
  /// Key frames; odometry and matches from each to the next, and the loops that were closed.
  FactorGraph factor_graph() const override {
    return {graph().nodes(), {}, graph().weighed_edges(), {}};
  }
  const PoseGraph& graph() const { return frames_.graph(); }

 private:
  struct ScanPlace {
    std::size_t frame = 0;
    geometry::Pose2 T_frame_robot;
  };

  void predict(const geometry::Pose2& T_odom_robot);
  /// What is known of the pose after the match.
  Eigen::Matrix3d place(const std::vector<Eigen::Vector2d>& points_m);
  /// The key frame that the robot is at: the last one, until it is far from it; then any of those
  /// around. Empty where a new one is due.
  std::optional<std::size_t> frame_here() const;
  /// How far the robot is from a frame, 1 where it is at it no more.
  double steps_from(std::size_t frame) const;
  void go_to_frame(std::size_t frame);
  void begin_frame(std::vector<Eigen::Vector2d> points_m, const Eigen::Matrix3d& information);
  void close_loops();
  void renew_field();
  void settle_gathered();

  ScanSlamParams params_;
  models::OdometryMotion motion_;
  ScanGathering gathering_;
  ScanMatcher matcher_;
  LoopClosing loops_;
  KeyFrames frames_;
  std::size_t frame_ = 0;            ///< That the robot is at.
  std::vector<std::size_t> around_;  ///< Frames that the robot is matched to.
  SurfaceField field_;               ///< Of these frames.
  double field_distance_m_ = 0.0;    ///< Driven since it was gathered.
  localization::PoseGaussian belief_;
  std::optional<geometry::Pose2> T_odom_last_;
  std::vector<ScanPlace> places_;  ///< Of all scans that are not being gathered.
  geometry::Pose2 T_map_placed_;   ///< At the last match.
  ScanMatch last_match_;
};

}  // namespace echomap::slam
