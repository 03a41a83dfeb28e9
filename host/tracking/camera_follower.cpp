// SPDX-License-Identifier: MIT
#include "host/tracking/camera_follower.hpp"

#include <chrono>
#include <utility>

namespace echomap::tracking {
namespace {

/// Of ten pictures a second so many are enough to know a start well.
constexpr std::chrono::seconds kLookAtStart(3);

bool is_same(const geometry::Pose2& a, const geometry::Pose2& b) {
  return a.position_m() == b.position_m() && a.heading_rad() == b.heading_rad();
}

}  // namespace

CameraFollower::CameraFollower(const sensors::RobotGeometry& robot,
                               FixStream fixes,
                               pipeline::RobotAtlas& atlas,
                               pipeline::ObservationSink& maps)
    : filter_(robot, std::move(fixes), geometry::Pose2(), std::nullopt),
      atlas_(atlas),
      maps_(maps) {}

void CameraFollower::begin(session::RobotSession& session) {
  filter_.begin(session);
  session.wait_until([] { return false; }, kLookAtStart);
  if (const auto belief = filter_.belief()) {
    T_map_camera_ = atlas_.pipeline().snapshot().latest.T_map_robot * belief->T_map_robot.inverse();
  }
}

void CameraFollower::poll(const session::RobotSession& session) {
  filter_.poll(session);
  const auto belief = filter_.belief();
  if (!belief || !T_map_camera_ || filter_.trajectory().empty()) {
    return;
  }
  if (observations_ != atlas_.record().observations() ||
      !is_same(T_camera_robot_, belief->T_map_robot)) {
    T_camera_robot_ = belief->T_map_robot;
    maps_.on_pose_fix({filter_.trajectory().back().stamp, *T_map_camera_ * T_camera_robot_});
    observations_ = atlas_.record().observations();
  }
}

std::unique_ptr<CameraFollower> camera_at(const std::string& address,
                                          const session::RobotProfile& profile,
                                          pipeline::RobotAtlas& atlas,
                                          pipeline::ObservationSink& maps) {
  return address.empty() ? nullptr
                         : std::make_unique<CameraFollower>(
                               profile.geometry, FixStream(open_fixes(address)), atlas, maps);
}

}  // namespace echomap::tracking
