// SPDX-License-Identifier: MIT
#include "host/session/operator_control.hpp"

#include <utility>
#include <variant>

#include "host/mapping/raster_map.hpp"

namespace echomap::session {
namespace {

using exploration::Motion;
using exploration::MotionResult;

/// One motion of a robot that is steered, and one look of a robot that stands.
constexpr double kSteerS = 0.05;
constexpr double kStandS = 0.1;
/// Unknown floor around the map that a way is planned on.
constexpr double kMarginM = 0.5;

/// What stopped a motion, where something did.
StandReason stand_reason(MotionResult result) {
  switch (result) {
    case MotionResult::kBumped:
      return StandReason::kBumped;
    case MotionResult::kHazard:
      return StandReason::kHazard;
    case MotionResult::kStalled:
      return StandReason::kStalled;
    case MotionResult::kLifted:
      return StandReason::kLifted;
    default:
      return StandReason::kNone;
  }
}

}  // namespace

OperatorControl::OperatorControl(OperatorQueue& queue,
                                 const OperatorParams& params,
                                 OperatorHooks hooks)
    : queue_(queue), params_(params), hooks_(std::move(hooks)) {}

bool OperatorControl::poll(WallTime now) {
  now_ = now;
  for (const OperatorCommand& command : queue_.take()) {
    std::visit([this](const auto& kind) { obey(kind); }, command);
  }
  if (mode_ == OperatorMode::kDriving && steer_.moves() && now_ - steer_.at > params_.silence) {
    stand(StandReason::kDriverSilent);
    is_blocked_ = true;
  }
  return std::exchange(ends_motion_, false);
}

Motion OperatorControl::next(const pipeline::Snapshot& snapshot, MotionResult last) {
  switch (mode_) {
    case OperatorMode::kDriving:
      return drive(last);
    case OperatorMode::kGoing:
      return go(snapshot, last);
    case OperatorMode::kStrategy:
    case OperatorMode::kStopped:
      break;
  }
  return exploration::Stand{kStandS};
}

std::optional<Eigen::Vector2d> OperatorControl::goal_m() const {
  return mode_ == OperatorMode::kGoing ? std::optional(goal_m_) : std::nullopt;
}

void OperatorControl::obey(const StopRobot& command) {
  switch (command.cause) {
    case StopRobot::Cause::kPressed:
      return stand(StandReason::kStopPressed);
    case StopRobot::Cause::kDriverGone:
      return stand(StandReason::kDriverGone);
    case StopRobot::Cause::kDriverSilent:
      return stand(StandReason::kDriverSilent);
  }
}

void OperatorControl::obey(const SteerRobot& command) {
  is_blocked_ = is_blocked_ && command.moves();
  if (is_blocked_ || now_ - command.at > params_.silence) {
    return;
  }
  ends_motion_ = ends_motion_ || mode_ != OperatorMode::kDriving;
  take(OperatorMode::kDriving);
  steer_ = command;
  reason_ = StandReason::kNone;
}

void OperatorControl::obey(const ResumeStrategy& /*command*/) {
  ends_motion_ = ends_motion_ || mode_ != OperatorMode::kStrategy;
  mode_ = OperatorMode::kStrategy;
  reason_ = StandReason::kNone;
}

void OperatorControl::obey(const GoTo& command) {
  ends_motion_ = true;
  take(OperatorMode::kGoing);
  reason_ = StandReason::kNone;
  goal_m_ = command.at_m;
  is_planned_ = false;
}

void OperatorControl::obey(const ReportMoved& /*command*/) {
  if (hooks_.on_moved) {
    hooks_.on_moved();
  }
}

void OperatorControl::obey(const PlaceRobot& command) {
  if (hooks_.on_placed) {
    hooks_.on_placed(command.T_map_robot);
  }
}

void OperatorControl::obey(const SetSpeed& command) {
  if (hooks_.on_speed) {
    hooks_.on_speed(command.factor);
  }
}

void OperatorControl::obey(const CarryOff& /*command*/) {
  if (hooks_.on_carry_off) {
    hooks_.on_carry_off();
  }
}

void OperatorControl::obey(const PutBox& command) {
  if (hooks_.on_box) {
    hooks_.on_box(command.at_m);
  }
}

void OperatorControl::obey(const CutCable& command) {
  if (hooks_.on_cut_cable) {
    hooks_.on_cut_cable(command.for_s);
  }
}

void OperatorControl::take(OperatorMode mode) {
  times_taken_ += mode_ == OperatorMode::kStrategy ? 1 : 0;
  mode_ = mode;
}

void OperatorControl::stand(StandReason reason) {
  ends_motion_ = true;
  take(OperatorMode::kStopped);
  reason_ = reason;
  steer_ = {};
}

/// The wheels roll on from one piece to the next; a stick in the middle lets them stand.
Motion OperatorControl::drive(MotionResult last) {
  if (const StandReason reason = stand_reason(last); reason != StandReason::kNone) {
    reason_ = reason;
    steer_ = {};
    is_blocked_ = true;
  }
  if (!steer_.moves()) {
    return exploration::Stand{kSteerS};
  }
  return exploration::Roll{
      steer_.forward * params_.forward_m_per_s, steer_.turn * params_.turn_rad_per_s, kSteerS};
}

Motion OperatorControl::go(const pipeline::Snapshot& snapshot, MotionResult last) {
  if (!is_planned_ && !plan(snapshot)) {
    stand(StandReason::kNoWay);
  } else if (const StandReason reason = stand_reason(last); reason != StandReason::kNone) {
    stand(reason);
    // NOLINTNEXTLINE(bugprone-unchecked-optional-access): plan() has set it
  } else if (const auto motion = navigator_->next(snapshot.latest.T_map_robot)) {
    return *motion;
  } else {
    stand(StandReason::kArrived);
  }
  ends_motion_ = false;
  return exploration::Stand{kStandS};
}

/// False where no way leads to the goal.
bool OperatorControl::plan(const pipeline::Snapshot& snapshot) {
  is_planned_ = true;
  navigator_.emplace(params_.navigator);
  const mapping::RasterMap map = navigator_->map_of(snapshot, kMarginM);
  const geometry::CellIndex goal = map.cell_at(goal_m_);
  if (map.state(goal) != mapping::CellState::kFree) {
    return false;
  }
  navigator_->set_map(map, snapshot);
  const auto cost_m = navigator_->travel().cost_m(goal);
  if (!cost_m) {
    return false;
  }
  navigator_->follow_path_to(snapshot.latest.T_map_robot, goal_m_, *cost_m);
  return true;
}

}  // namespace echomap::session
