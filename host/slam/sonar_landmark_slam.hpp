// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "host/sensors/range_scan.hpp"
#include "host/slam/ekf_slam.hpp"
#include "host/slam/kept_way.hpp"
#include "host/slam/landmark_graph.hpp"
#include "host/slam/landmark_update.hpp"
#include "host/slam/multiscan.hpp"
#include "host/slam/odometry_piece.hpp"
#include "host/slam/scan_map.hpp"
#include "host/slam/slam_method.hpp"
#include "host/slam/sonar_landmarks.hpp"

namespace echomap::slam {

/// How good the odometry may be: factors of the deviations that the settings say.
struct OdometryTrust {
  double steady_scale = 1.0;  ///< Of what is off all the time.
  double chance_scale = 1.0;  ///< Of what is off by chance.
  double surprise = 0.0;      ///< That odometry is so, before anything was seen.
};

/// Settings of a SonarLandmarkSlam; the default is for one panned sonar or a ring of them.
struct SonarLandmarkSlamParams {
  MultiscanParams gathering{.most_echoes = 600};
  SonarLandmarksParams landmarks{};
  EkfSlamParams filter{};
  OdometryNoise odometry{};
  /// Of how odometry is off all the time, before anything was seen: as MultiscanAlignmentParams.
  Eigen::Vector3d calibration_sd{0.03, 0.05, 0.03};
  /// Each is followed all the time; what surprises least is believed. That odometry is good is
  /// believed until much speaks against it.
  std::vector<OdometryTrust> trusts{{1.0, 1.0, 20.0}, {0.25, 0.2, 0.0}};
  /// The gate of 90 %: rather a sighting too few than one of another thing.
  LandmarkUpdateParams update{.association = {.gate = 4.61},
                              .provisional = {.sightings = 2, .farthest_m = 0.2}};
  KeptWayParams way{};
  ScanMapParams map{};
  std::uint32_t seed = 1;  ///< Of the pairs of echoes that are drawn.
};

/// EKF-SLAM with cones. Readings are gathered over a stretch of the way; walls and points are found
/// among its echoes, and the filter takes them as seen from where the stretch began. How odometry
/// is off all the time is a part of the state.
class SonarLandmarkSlam final : public SlamMethod {
 public:
  /// Throws std::invalid_argument for parameters without sense.
  explicit SonarLandmarkSlam(const SonarLandmarkSlamParams& params = {});

  void follow(const geometry::Pose2& T_odom_robot) override;
  void carry(const geometry::Pose2& T_odom_robot) override;
  void add(const geometry::Pose2& T_odom_robot, const sensors::RangeScan& scan) override;
  localization::PoseGaussian belief() const override;
  std::vector<geometry::Pose2> trajectory() const override;
  mapping::OccupancyGrid grid() const override;
  FactorGraph factor_graph() const override { return landmark_graph(filter()); }

  /// Its robot is where the stretch began that is being gathered.
  const EkfSlam& filter() const { return estimates_[best_].filter; }
  std::size_t best() const { return best_; }

 private:
  /// What is thought under one trust in the odometry.
  struct Estimate {
    EkfSlam filter;
    LandmarkUpdate update;
    KeptWay way;
    double surprise = 0.0;  ///< Of all sightings so far.
  };

  void begin_at(const geometry::Pose2& T_odom_robot);
  void begin_once(const geometry::Pose2& T_odom_robot);
  void finish_multiscan(const OdometryPiece& piece);
  CalibratedMotion motion_by(const OdometryPiece& piece, std::size_t estimate) const;

  SonarLandmarkSlamParams params_;
  MultiscanGathering gathering_;
  std::vector<Estimate> estimates_;  ///< One for each trust.
  std::size_t best_ = 0;             ///< That which surprises least.
  std::mt19937 random_;
  bool has_begun_ = false;
  std::vector<OdometryPiece> open_;  ///< To each scan, from where the stretch began.
  std::vector<sensors::RangeScan> scans_;
};

}  // namespace echomap::slam
