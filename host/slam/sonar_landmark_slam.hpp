// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "host/sensors/range_scan.hpp"
#include "host/slam/ekf_slam_filter.hpp"
#include "host/slam/landmark_graph.hpp"
#include "host/slam/landmark_update.hpp"
#include "host/slam/multiscan.hpp"
#include "host/slam/odometry_piece.hpp"
#include "host/slam/pose_history.hpp"
#include "host/slam/slam_method.hpp"
#include "host/slam/sonar_landmarks.hpp"

namespace echomap::slam {

/// A hypothesis of how accurate the odometry is: factors on the deviations of the settings.
struct OdometryNoisePrior {
  double steady_scale = 1.0;  ///< Scale of the systematic deviations.
  double chance_scale = 1.0;  ///< Scale of the random deviations.
  double negative_log_evidence =
      0.0;  ///< Negative logarithm of the prior probability of this hypothesis.
};

/// Settings of a SonarLandmarkSlam; the default is for one panned sonar or a ring of them.
struct SonarLandmarkSlamParams {
  MultiscanParams gathering{.max_echoes = 600};
  SonarLandmarksParams landmarks{};
  EkfSlamFilterParams filter{};
  OdometryNoise odometry{};
  /// Of how odometry is off all the time, before anything was seen: as MultiscanAlignmentParams.
  Eigen::Vector3d calibration_stddev{0.03, 0.05, 0.03};
  /// All hypotheses are tracked; the one with the least negative log evidence is reported. The
  /// prior favours accurate odometry.
  std::vector<OdometryNoisePrior> noise_hypotheses{{1.0, 1.0, 20.0}, {0.25, 0.2, 0.0}};
  /// The gate of 90 %: rather a sighting too few than one of another thing.
  LandmarkUpdateParams update{.association = {.gate = 4.61},
                              .provisional = {.sightings = 2, .max_m = 0.2}};
  PoseHistoryParams pose_history{};
  std::uint32_t seed = 1;  ///< Seed of the sampled pairs of echoes.
};

/// EKF-SLAM with cones. Readings are gathered over a stretch of the way; walls and points are found
/// among its echoes, and the filter takes them as seen from where the stretch began. How odometry
/// is off all the time is a part of the state.
class SonarLandmarkSlam final : public SlamMethod {
 public:
  /// Throws std::invalid_argument for invalid parameters.
  explicit SonarLandmarkSlam(const SonarLandmarkSlamParams& params = {});

  void follow(const geometry::Pose2& T_odom_robot) override;
  void carry(const geometry::Pose2& T_odom_robot) override;
  void add(const geometry::Pose2& T_odom_robot, const sensors::RangeScan& scan) override;
  localization::PoseGaussian belief() const override;
  std::vector<geometry::Pose2> trajectory() const override;
  FactorGraph factor_graph() const override { return landmark_graph(filter()); }

  /// Its robot is where the stretch began that is being gathered.
  const EkfSlamFilter& filter() const { return estimates_[best_].filter; }
  std::size_t best() const { return best_; }

 private:
  /// The estimate under one hypothesis of the odometry.
  struct Estimate {
    EkfSlamFilter filter;
    LandmarkUpdate update;
    PoseHistory pose_history;
    double negative_log_evidence = 0.0;  ///< Negative log evidence of all sightings so far.
  };

  void begin_at(const geometry::Pose2& T_odom_robot);
  void begin_once(const geometry::Pose2& T_odom_robot);
  void finish_multiscan(const OdometryPiece& piece);
  CalibratedMotion motion_by(const OdometryPiece& piece, std::size_t estimate) const;

  SonarLandmarkSlamParams params_;
  MultiscanGathering gathering_;
  std::vector<Estimate> estimates_;  ///< One estimate per hypothesis.
  std::size_t best_ = 0;  ///< Index of the hypothesis with the least negative log evidence.
  std::mt19937 random_;
  std::vector<OdometryPiece> open_;  ///< To each scan, from where the stretch began.
};

}  // namespace echomap::slam
