// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "host/models/cut_step_spread.hpp"
#include "host/slam/data_association.hpp"
#include "host/slam/ekf_slam.hpp"
#include "host/slam/landmark_extraction.hpp"
#include "host/slam/provisional_landmarks.hpp"
#include "host/slam/scan_map.hpp"
#include "host/slam/slam_method.hpp"

namespace echomap::slam {

/// How sightings find their landmarks.
enum class AssociationMethod : std::uint8_t { kNearestNeighbour, kJointCompatibility };

/// Settings of a LandmarkSlam; the default is for a laser indoors.
struct LandmarkSlamParams {
  EkfSlamParams filter{};
  /// Of the pose at the first scan, by x, y (m) and heading (rad): none where the map begins there.
  Eigen::Matrix3d start_covariance = Eigen::Matrix3d::Zero();
  models::OdometryMotionParams motion{};
  models::WholeStep whole_step{};
  LandmarkExtractionParams extraction{};
  AssociationMethod method = AssociationMethod::kJointCompatibility;
  AssociationParams association{};
  ProvisionalLandmarksParams provisional{};
  /// A landmark is taken out of the map once beams have passed through where it should be by this
  /// share of its sightings, and at least so often.
  double pruned_share = 0.5;
  std::size_t least_passes = 5;
  /// A beam has passed that ends so much farther.
  double pass_margin_m = 0.5;
  /// A pose is kept every so often, for what is learnt later to correct the way up to there; where
  /// there are too many, every other one is let go and they are kept half as often.
  double kept_every_m = 1.0;
  double kept_every_rad = 0.5;
  std::size_t most_kept = 100;
  ScanMapParams map{};
};

/// EKF-SLAM of the paper (Akzhalova and Polichshuk): odometry moves the robot, landmarks are
/// extracted from each scan and associated with those of the map; those that are known correct the
/// state, those that are not are added once they have been seen often enough.
class LandmarkSlam : public SlamMethod {
 public:
  /// Throws std::invalid_argument for parameters without sense.
  explicit LandmarkSlam(const LandmarkSlamParams& params = {});

  void add(const geometry::Pose2& T_odom_robot, const RangeScan& scan) override;
  localization::PoseGaussian belief() const override { return filter_.belief(); }
  std::vector<geometry::Pose2> trajectory() const override;
  mapping::OccupancyGrid grid() const override;
  /// What the filter knows of each by itself (its marginals; that errors of two are alike is lost):
  /// edges from the first pose, which is taken as known, to those kept, to the last one and to all
  /// landmarks that are points. Walls are left out.
  FactorGraph factor_graph() const override;

  const EkfSlam& filter() const { return filter_; }

 private:
  /// Where a scan was taken, from the last pose that was kept before.
  struct Instant {
    std::size_t kept = 0;
    geometry::Pose2 T_kept_robot;
  };

  void move_to(const geometry::Pose2& T_odom_robot);
  std::vector<Candidate> paired(std::span<const Candidate> candidates) const;
  void correct(std::span<const LandmarkSighting> sightings, std::span<const Candidate> pairs);
  void extend(std::span<const LandmarkSighting> sightings,
              std::span<const std::size_t> unknown,
              const geometry::Pose2& T_odom_robot);
  void prune(const RangeScan& scan);
  void keep_pose();
  void thin_out_kept();

  LandmarkSlamParams params_;
  models::OdometryMotion motion_;
  EkfSlam filter_;
  ProvisionalLandmarks provisional_;
  std::optional<geometry::Pose2> T_odom_robot_;
  double kept_every_ = 1.0;  ///< In units of the settings.
  std::vector<Instant> instants_;
  std::vector<RangeScan> scans_;
};

}  // namespace echomap::slam
