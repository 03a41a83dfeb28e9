// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

#include "host/models/odometry_motion.hpp"
#include "host/slam/pose_graph.hpp"
#include "host/slam/scan_matching.hpp"
#include "host/slam/slam_method.hpp"
#include "host/slam/surface_field.hpp"

namespace echomap::slam {

/// How ScanSlam works.
struct ScanSlamParams {
  SurfaceFieldParams field;
  ScanMatchingParams matching;
  PoseGraphParams graph;
  /// How far odometry may be off: three times the default of a good base, since what it is off by
  /// is not known of a log.
  models::OdometryMotionParams motion{0.01, 0.0025, 0.0025, 1e-3, 1e-3};
  /// Of every step, metres and radians: odometry is rounded, and scans are not taken at its instant.
  double least_spread_m = 0.005;
  double least_spread_rad = 0.005;
  /// Points nearer to the one before say nothing new, metres.
  double point_spacing_m = 0.05;
  /// Scans are gathered until they have so many points, metres and radians of the way or not.
  std::size_t least_points = 80;
  /// A key frame is begun after such a way or turn.
  double key_frame_m = 0.5;
  double key_frame_rad = 0.5;
  /// The scans of the last metres of the way are what a new one is matched to.
  double local_way_m = 12.0;
};

/// Scan-to-map SLAM.
class ScanSlam : public SlamMethod {
 public:
  /// Throws std::invalid_argument for parameters that make no sense.
  explicit ScanSlam(const ScanSlamParams& params = {});

  void add(const geometry::Pose2& T_odom_robot, const RangeScan& scan) override;
  localization::PoseGaussian belief() const override { return belief_; }
  std::vector<geometry::Pose2> trajectory() const override;
  mapping::OccupancyGrid grid() const override;
  const PoseGraph& graph() const { return graph_; }
  double last_share() const { return last_share_; }

 private:
  struct GatheredScan {
    geometry::Pose2 T_odom_robot;
    std::vector<Eigen::Vector2d> points_m;  ///< Robot's frame.
  };
  struct PlacedScan {
    std::size_t key_frame = 0;
    geometry::Pose2 T_key_scan;
  };
  struct KeyFrame {
    std::vector<Eigen::Vector2d> points_m;
    std::vector<Eigen::Vector2d> all_points_m;
    double way_m = 0.0;
  };

  void predict(const geometry::Pose2& T_odom_robot);
  std::vector<Eigen::Vector2d> gathered_points_m() const;
  void add_key_frame(std::vector<Eigen::Vector2d> points_m, const Eigen::Matrix3d& information);
  void rebuild_field();

  ScanSlamParams params_;
  models::OdometryMotion motion_;
  ScanMatcher matcher_;
  SurfaceField field_;
  PoseGraph graph_;
  std::vector<KeyFrame> key_frames_;
  localization::PoseGaussian belief_;
  geometry::Pose2 T_odom_last_;
  std::vector<GatheredScan> gathered_;
  std::size_t gathered_count_ = 0;
  std::vector<PlacedScan> placed_;
  double last_share_ = 0.0;
};

}  // namespace echomap::slam
