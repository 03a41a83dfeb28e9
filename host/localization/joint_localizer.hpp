// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "host/localization/ekf_outcome.hpp"
#include "host/localization/peer_sighting.hpp"
#include "host/localization/pose_gaussian.hpp"
#include "host/localization/pose_measurement.hpp"
#include "host/models/cut_step_spread.hpp"

namespace echomap::localization {

/// An error that many sightings in a row have in common: first-order Gauss-Markov.
struct SlowError {
  double stddev = 0.0;
  double time_constant_s = 10.0;  ///< After this time 1/e of it is left.
};

/// Settings of a JointLocalizer. Those of errors are of the robots of UTIAS MRCLAM, measured on its
/// set 7 (docs/algorithms/joint_localization.md).
struct JointLocalizerParams {
  models::OdometryMotionParams motion{
      .alpha1 = 0.04, .alpha2_rad2_per_m2 = 0.03, .alpha3 = 0.02, .side_slip = 1.6e-3};
  models::WholeStep whole_step{};
  /// Standard deviations of what odometry reads long or short for ever, as shares; 0: not at all.
  double drive_scale_stddev = 0.02;
  double turn_scale_stddev = 0.02;
  /// Share by which a robot's ranges, of whatever it sees, are off.
  SlowError range_scale{0.025, 10.0};
  /// The same of its ranges to one target.
  SlowError target_range_scale{0.035, 10.0};
  /// What a robot's bearings are off by, radians.
  SlowError bearing_rad{0.015, 10.0};
  /// Squared Mahalanobis distance beyond which a sighting is rejected: 99.9 % of chi square with
  /// two degrees of freedom.
  double gate = 13.82;
  /// After so many rejected sightings of landmarks in a row a robot is taken for lost, and its pose
  /// for less certain by these.
  std::size_t max_gated_in_a_row = 10;
  double lost_stddev_m = 0.5;
  double lost_stddev_rad = 0.3;
};

/// Localizes a team of robots that see landmarks of the map and each other: one extended Kalman
/// filter over the poses of all (Roumeliotis and Bekey 2002), with the correlations that sightings
/// of each other bring about, so that nothing counts twice. What errs slowly, the scales of a
/// robot's odometry and the errors that its sightings share, is estimated along with the poses.
///
/// Odometry and sightings are to come in the order of their stamps. Whatever is refused leaves all
/// beliefs as they are.
class JointLocalizer {
 public:
  /// Throws std::invalid_argument for invalid parameters.
  explicit JointLocalizer(const JointLocalizerParams& params = {});

  /// Adds a robot that is at `start` at that time; answers its index. Throws std::invalid_argument
  /// for a start that is not finite or has no positive definite covariance.
  std::size_t add_robot(double stamp_s, const PoseGaussian& start);
  /// A motion of a robot by its odometry since the last one; answers kApplied, kTimeRanBack or
  /// kNotFinite.
  EkfOutcome move(std::size_t robot, double stamp_s, const geometry::Pose2& T_before_after);
  /// A sighting of the landmark with that number; the standard deviations in it are of what does
  /// not last from sighting to sighting.
  EkfOutcome see_landmark(std::size_t robot, std::int64_t number, const LandmarkObservation& seen);
  /// A sighting of another robot of the team, by which both become more certain.
  EkfOutcome see_peer(std::size_t observer, std::size_t peer, const PeerSighting& seen);

  std::size_t robots() const { return robots_.size(); }
  PoseGaussian belief(std::size_t robot) const;
  /// Covariance of the poses of two robots.
  Eigen::Matrix3d covariance_between(std::size_t robot, std::size_t other) const;
  /// Estimated scales of a robot's odometry: true drive and turn by reported ones.
  Eigen::Vector2d odometry_scales(std::size_t robot) const;
  /// How often each outcome has been answered.
  std::size_t count(EkfOutcome outcome) const { return counts_[static_cast<std::size_t>(outcome)]; }
  /// How often a robot has been taken for lost.
  std::size_t times_lost(std::size_t robot) const { return robots_[robot].times_lost; }

 private:
  struct Robot {
    Eigen::Index at = 0;  ///< Where its numbers begin in the state.
    double moved_s = 0.0;
    double sighted_s = 0.0;  ///< Until when its slow errors are carried on.
    std::size_t gated_in_a_row = 0;
    std::size_t times_lost = 0;
  };
  struct TargetError {
    Eigen::Index at = 0;
    double sighted_s = 0.0;
  };
  /// Robot, and target: a landmark's number, or -1 - index of a peer.
  using Pair = std::pair<std::size_t, std::int64_t>;

  EkfOutcome counted(EkfOutcome outcome);
  EkfOutcome see(const Pair& pair, const LandmarkObservation& seen, const Robot* peer);
  EkfOutcome correct(const Eigen::Matrix<double, 2, Eigen::Dynamic>& jacobian,
                     const Eigen::Vector2d& innovation,
                     const Eigen::Matrix2d& noise);
  Eigen::Index append(double variance);
  void decay(Eigen::Index at, const SlowError& error, double duration_s);
  Eigen::Index target_error(const Pair& pair, double stamp_s);
  void note_landmark(Robot& robot, EkfOutcome outcome);

  JointLocalizerParams params_;
  models::OdometryMotion motion_;
  std::vector<Robot> robots_;
  std::map<Pair, TargetError> target_errors_;
  /// The latest stamp of anything.
  double now_s_;
  Eigen::VectorXd mean_;
  Eigen::MatrixXd covariance_;
  std::array<std::size_t, kEkfOutcomes> counts_{};
};

}  // namespace echomap::localization
