// SPDX-License-Identifier: MIT
#include "host/tracking/strategy_drive.hpp"

#include <utility>
#include <variant>

#include "host/session/pipeline_setup.hpp"

namespace echomap::tracking {
namespace {

/// Of a stretch, in radii of the robot's body: 2 m of a Create, 0.4 m of an e-puck.
constexpr double kStretchRadii = 12.0;
constexpr double kStandS = 0.1;

}  // namespace

StrategyDrive::StrategyDrive(session::RobotContext& robot, MakeExplorer make)
    : robot_(robot),
      make_(std::move(make)),
      atlas_(session::atlas_for(robot.profile(), session::kNoSlam, only_map())),
      explorer_(make_()) {
  robot_.fork().add(atlas_);
}

StrategyDrive::~StrategyDrive() { robot_.fork().remove(atlas_); }

void StrategyDrive::begin_new_map(std::size_t stops_elsewhere) {
  robot_.recorder().add_event(
      {recording::SessionEventKind::kBeginNewMap, static_cast<std::int64_t>(stops_elsewhere), {}});
  atlas_.begin_new_map(stops_elsewhere);
  explorer_ = make_();
  last_ = exploration::MotionResult::kReached;
}

bool StrategyDrive::go_to_next_stop() {
  const double stretch_m = kStretchRadii * robot_.profile().body_radius_m;
  double travelled_m = 0.0;
  while (!robot_.session().end()) {
    const auto before = atlas_.pipeline().snapshot();
    const auto motion = explorer_->next(before, last_);
    const auto* finished = std::get_if<exploration::Finished>(&motion);
    if (finished != nullptr && finished->reason == exploration::FinishReason::kLifted) {
      robot_.move(exploration::Stand{kStandS});  // Waits until it is put down.
      begin_new_map(0);
      return !robot_.session().end();
    }
    if (finished != nullptr) {
      finished_ = finished->reason;
      return false;
    }
    last_ = robot_.move(motion);
    travelled_m += (atlas_.pipeline().pose_estimate().T_map_robot.position_m() -
                    before.latest.T_map_robot.position_m())
                       .norm();
    if (std::holds_alternative<exploration::EndScan>(motion) || travelled_m >= stretch_m) {
      return !robot_.session().end();
    }
  }
  return false;
}

}  // namespace echomap::tracking
