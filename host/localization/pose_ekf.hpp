// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "host/localization/ekf_outcome.hpp"
#include "host/localization/pose_gaussian.hpp"
#include "host/localization/pose_measurement.hpp"
#include "host/models/cut_step_spread.hpp"

namespace echomap::localization {

/// Settings of a PoseEkf; ours unless said.
struct PoseEkfParams {
  models::OdometryMotionParams motion{};
  models::WholeStep whole_step{};
  /// What is farther off than this, squared, is not believed: 99.9 % of chi square with two and
  /// three degrees of freedom.
  double gate_of_two = 13.82;
  double gate_of_three = 16.27;
  /// A measurement that comes later than this is too old.
  double history_s = 2.0;
  /// As many measurements wait for odometry of their time.
  std::size_t max_held = 64;
};

/// Follows a robot whose pose is about known: extended Kalman filter (Mahmood and Ridao 2017,
/// Algorithm 1; Thrun, Burgard and Fox 2005, table 7.2) of odometry, pose fixes and landmarks.
///
/// Measurements may come in any order and late: each is put where it belongs into a short history
/// of odometry and measurements, and all after it is done again, so that the belief is what it had
/// been in the right order. Whatever is refused leaves the belief as it is.
class PoseEkf {
 public:
  /// Where the robot is at the first odometry pose. Throws std::invalid_argument for a start that
  /// is not finite or has no positive definite covariance, and for invalid parameters.
  explicit PoseEkf(const PoseGaussian& start, const PoseEkfParams& params = {});

  /// Where the robot is by its odometry; answers kApplied, kTimeRanBack or kNotFinite.
  EkfOutcome move(double stamp_s, const geometry::Pose2& T_odom_robot);
  /// Takes a measurement, of the past or ahead of the odometry.
  EkfOutcome update(const PoseMeasurement& measurement);

  /// At the last odometry pose.
  const PoseGaussian& belief() const { return history_.empty() ? start_ : history_.back().belief; }
  /// How often each outcome has been told or, for what was held, come to.
  std::size_t count(EkfOutcome outcome) const { return counts_[static_cast<std::size_t>(outcome)]; }

 private:
  /// An instant with all that is known of it.
  struct Node {
    double stamp_s = 0.0;
    geometry::Pose2 T_odom_robot;
    std::optional<PoseMeasurement> measurement;
    PoseGaussian belief;
  };

  EkfOutcome counted(EkfOutcome outcome);
  EkfOutcome insert(const PoseMeasurement& measurement);
  EkfOutcome correct(Node& node) const;
  PoseGaussian predicted(const Node& from, const geometry::Pose2& T_odom_robot) const;
  void release_held();
  void forget();

  PoseEkfParams params_;
  models::OdometryMotion motion_;
  PoseGaussian start_;
  std::deque<Node> history_;
  std::vector<PoseMeasurement> held_;
  std::array<std::size_t, kEkfOutcomes> counts_{};
};

}  // namespace echomap::localization
