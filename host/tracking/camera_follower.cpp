// SPDX-License-Identifier: MIT
#include "host/tracking/camera_follower.hpp"

#include <chrono>
#include <utility>

namespace echomap::tracking {
namespace {

/// Of ten pictures a second so many are enough to know a start well.
constexpr std::chrono::seconds kLookAtStart(3);

}  // namespace

CameraFollower::CameraFollower(const sensors::RobotGeometry& robot,
                               FixStream fixes,
                               pipeline::RobotPipeline& pipeline)
    : filter_(robot, std::move(fixes), geometry::Pose2(), std::nullopt), pipeline_(pipeline) {}

void CameraFollower::begin(session::RobotSession& session) {
  filter_.begin(session);
  session.wait_until([] { return false; }, kLookAtStart);
  if (const auto belief = filter_.belief()) {
    T_map_camera_ = belief->T_map_robot.inverse();
  }
}

void CameraFollower::poll(const session::RobotSession& session) {
  filter_.poll(session);
  const auto belief = filter_.belief();
  if (belief && T_map_camera_) {
    pipeline_.move_to(*T_map_camera_ * belief->T_map_robot);
  }
}

std::unique_ptr<CameraFollower> camera_at(const std::string& address,
                                          const session::RobotProfile& profile,
                                          pipeline::RobotPipeline& pipeline) {
  return address.empty() ? nullptr
                         : std::make_unique<CameraFollower>(
                               profile.geometry, FixStream(open_fixes(address)), pipeline);
}

}  // namespace echomap::tracking
