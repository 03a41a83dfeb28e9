// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "host/pipeline/robot_pipeline.hpp"
#include "host/session/robot_profile.hpp"
#include "host/tracking/ekf_filter.hpp"

namespace echomap::tracking {

/// Keeps the robot of a pipeline where an overhead camera and its odometry together have it. The
/// map frame remains the robot's pose at its start, wherever the camera's lies.
class CameraFollower final : public session::Follower {
 public:
  /// `pipeline` outlives this.
  CameraFollower(const sensors::RobotGeometry& robot,
                 FixStream fixes,
                 pipeline::RobotPipeline& pipeline);

  /// Takes what the robot senses, before the pipeline does.
  pipeline::ObservationSink& sink() override { return filter_.sink(); }
  /// The robot is connected and stands, and goes on standing until it is known well where. Throws
  /// CommandError 1 where no fix comes.
  void begin(session::RobotSession& session) override;
  /// After every step of the session's time.
  void poll(const session::RobotSession& session) override;

 private:
  EkfFilter filter_;
  pipeline::RobotPipeline& pipeline_;
  std::optional<geometry::Pose2> T_map_camera_;
};

/// Of the camera whose fixes come to that address; null for an empty one. Throws CommandError 1
/// where it cannot be listened to.
std::unique_ptr<CameraFollower> camera_at(const std::string& address,
                                          const session::RobotProfile& profile,
                                          pipeline::RobotPipeline& pipeline);

}  // namespace echomap::tracking
