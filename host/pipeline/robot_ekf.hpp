// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "host/localization/heading_filter.hpp"
#include "host/localization/pose_ekf.hpp"
#include "host/pipeline/observation_sink.hpp"
#include "host/pipeline/snapshot.hpp"
#include "host/sensors/robot_geometry.hpp"

namespace echomap::pipeline {

/// How a robot is followed by fixes; ours.
struct RobotEkfParams {
  localization::PoseEkfParams ekf;
  localization::HeadingFilterParams heading;
  /// After so many fixes in a row that cannot be, the robot is where they say, not where it was
  /// thought to be.
  std::size_t max_gated = 10;
  /// A fix that the filter starts from is old by the time it comes: added to its deviations.
  double start_stddev_m = 0.05;
  double start_stddev_rad = 0.1;
};

/// Follows a robot that drives by its odometry and fixes of its pose. Its turns are those of gyro
/// and wheels together where it has a gyro. It starts with `start_at` or the first fix, and anew
/// with the next fix when the robot was lifted.
class RobotEkf final : public ObservationSink {
 public:
  explicit RobotEkf(const sensors::RobotGeometry& robot, const RobotEkfParams& params = {});

  /// The robot is about there at its next odometry.
  void start_at(const localization::PoseGaussian& start);
  /// Stamped on the odometry's clock; in any order. Answers kApplied where it starts the filter,
  /// kHeld where the odometry has to get there first, and
  /// kTooOld for one from before the robot was put down.
  localization::EkfOutcome add(const localization::PoseFix& fix);

  void on_odometry(const sensors::OdometryObservation& observation) override;
  /// Sonar is not listened to.
  void on_sonar(const sensors::SonarObservation& /*observation*/) override {}
  void on_yaw(const sensors::YawObservation& observation) override;
  void on_hazards(const sensors::HazardObservation& observation) override;
  void begin_scan() override {}
  void end_scan() override {}

  /// Empty before a start.
  std::optional<localization::PoseGaussian> belief() const;
  /// Where it was believed to be at each odometry, by what was known then.
  const std::vector<StampedPose>& trajectory() const { return trajectory_; }
  /// Of the last odometry; empty before.
  std::optional<time::RobotTime> stamp() const { return stamp_; }
  /// Fixes that were taken, and those that could not be, since the session began.
  std::size_t applied() const { return applied_; }
  std::size_t gated() const { return gated_; }
  /// Fixes that were too old, not finite or of no use otherwise.
  std::size_t refused() const { return refused_; }
  /// How often it started anew after many fixes elsewhere, or after the robot was lifted.
  std::size_t times_lost() const { return times_lost_; }

 private:
  localization::EkfOutcome hold(const localization::PoseFix& fix);
  void add_held();
  localization::EkfOutcome apply(const localization::PoseFix& fix);
  void start_from(const localization::PoseFix& fix);
  /// The heading after wheels that have turned the robot by so much more, from where it started.
  double heading_rad_after(double wheel_turn_rad);

  sensors::RobotGeometry robot_;
  RobotEkfParams params_;
  std::optional<localization::PoseEkf> ekf_;
  localization::HeadingFilter heading_;
  geometry::Pose2 T_odom_robot_;
  std::optional<sensors::WheelTravel> travel_;
  std::optional<time::RobotTime> stamp_;
  std::optional<sensors::Yaw> yaw_;       ///< The newest; empty without a gyro.
  std::optional<sensors::Yaw> used_yaw_;  ///< Up to there the heading filter has gone.
  double wheel_turn_rad_ = 0.0;           ///< Since then.
  double heading_rad_ = 0.0;              ///< At the last odometry, not wrapped.
  bool is_lifted_ = false;
  std::optional<time::RobotTime> landed_;    ///< Since then it is where fixes say.
  std::vector<localization::PoseFix> held_;  ///< Ahead of the odometry.
  std::vector<StampedPose> trajectory_;
  std::size_t applied_ = 0;
  std::size_t gated_ = 0;
  std::size_t gated_in_a_row_ = 0;
  std::size_t refused_ = 0;
  std::size_t times_lost_ = 0;
};

}  // namespace echomap::pipeline
