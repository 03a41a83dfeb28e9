// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "host/pipeline/robot_ekf.hpp"
#include "host/tracking/fix_stream.hpp"
#include "host/tracking/live_filter.hpp"
#include "host/tracking/start_pose.hpp"

namespace echomap::tracking {

/// Extended Kalman filter of odometry, gyro and the fixes of an overhead camera.
class EkfFilter final : public LiveFilter {
 public:
  /// Without `start` the first fix tells where the robot is. `T_map_camera` is where the map has
  /// the frame of the fixes.
  EkfFilter(const sensors::RobotGeometry& robot,
            FixStream fixes,
            const geometry::Pose2& T_map_camera,
            const std::optional<StartPose>& start);

  pipeline::ObservationSink& sink() override { return ekf_; }
  void poll(const session::RobotSession& session) override;
  /// Throws CommandError 1 where there is no start and no fix comes within five seconds.
  void begin(session::RobotSession& session) override;
  bool has_lost_it() override;
  /// Empty before a start.
  std::optional<localization::PoseGaussian> belief() const { return ekf_.belief(); }
  std::optional<localization::PoseGaussian> estimate() const override { return belief(); }
  /// A camera tells everywhere.
  double telling(const geometry::Pose2& /*T_robot_goal*/) const override { return 0.0; }
  std::string line() const override;
  nlohmann::ordered_json report() const override;
  const std::vector<pipeline::StampedPose>& trajectory() const override {
    return ekf_.trajectory();
  }

 private:
  void wait_for_fix(session::RobotSession& session) const;
  /// Warns where no fix was of use for long.
  void look_for_silence(time::HostTime now);
  double stamp_s_of(time::HostTime instant, const session::RobotSession& session) const;

  pipeline::RobotEkf ekf_;
  FixStream fixes_;
  geometry::Pose2 T_map_camera_;
  std::optional<StartPose> start_;
  std::optional<time::HostTime> silent_since_;  ///< Empty before the drive.
  bool silence_is_told_ = false;
  std::size_t applied_ = 0;  ///< Fixes, when one was last applied.
  std::size_t losses_told_ = 0;
  bool was_lost_ = false;  ///< Since the last stop.
};

}  // namespace echomap::tracking
