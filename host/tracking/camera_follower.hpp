// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include "host/pipeline/robot_atlas.hpp"
#include "host/session/follower.hpp"
#include "host/session/robot_profile.hpp"
#include "host/tracking/ekf_filter.hpp"

namespace echomap::tracking {

/// Keeps the robot of an atlas where an overhead camera and its odometry together have it. The map
/// frame remains the one that the atlas has, wherever the camera's lies.
class CameraFollower final : public session::Follower {
 public:
  /// `maps` leads to `atlas`; both outlive this.
  CameraFollower(const sensors::RobotGeometry& robot,
                 FixStream fixes,
                 pipeline::RobotAtlas& atlas,
                 pipeline::ObservationSink& maps);

  /// Takes what the robot senses, before the atlas does.
  pipeline::ObservationSink& sink() override { return filter_.sink(); }
  /// The robot is connected and stands, and goes on standing until it is known well where. Throws
  /// CommandError 1 where no fix comes.
  void begin(session::RobotSession& session) override;
  /// After every step of the session's time.
  void poll(const session::RobotSession& session) override;

 private:
  EkfFilter filter_;
  pipeline::RobotAtlas& atlas_;
  pipeline::ObservationSink& maps_;
  std::optional<geometry::Pose2> T_map_camera_;
  geometry::Pose2 T_camera_robot_;  ///< Of the last fix that the atlas was given.
  std::size_t observations_ = 0;    ///< Of the atlas, with that fix.
};

/// Of the camera whose fixes come to that address; null for an empty one. Throws CommandError 1
/// where it cannot be listened to.
std::unique_ptr<CameraFollower> camera_at(const std::string& address,
                                          const session::RobotProfile& profile,
                                          pipeline::RobotAtlas& atlas,
                                          pipeline::ObservationSink& maps);

}  // namespace echomap::tracking
