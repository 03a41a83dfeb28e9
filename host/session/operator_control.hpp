// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

#include "host/exploration/explorer.hpp"
#include "host/exploration/navigator.hpp"
#include "host/pipeline/snapshot.hpp"
#include "host/session/operator_command.hpp"
#include "host/session/operator_queue.hpp"

namespace echomap::session {

/// Who has the robot.
enum class OperatorMode : std::uint8_t {
  kStrategy,  ///< No person.
  kStopped,
  kDriving,
  kGoing,  ///< To where a person has sent it.
};

/// Why a robot that a person has stands.
enum class StandReason : std::uint8_t {
  kNone,
  kStopPressed,
  kDriverGone,
  kDriverSilent,
  kBumped,
  kHazard,
  kStalled,
  kLifted,
  kNoWay,
  kArrived,
};

/// How a person's commands become motions.
struct OperatorParams {
  exploration::NavigatorParams navigator;
  double forward_m_per_s = 0.0;  ///< Of a stick that is pushed all the way.
  double turn_rad_per_s = 0.0;   ///< The same.
  /// Wheels that somebody steers stop after so long without a word of him.
  std::chrono::milliseconds silence{250};
};

/// What a person may ask for beside motions; null where the run cannot do it.
struct OperatorHooks {
  std::function<void()> on_moved = nullptr;
  std::function<void(const geometry::Pose2& T_map_robot)> on_placed = nullptr;
  std::function<void(double factor)> on_speed = nullptr;
  std::function<void()> on_carry_off = nullptr;
  std::function<void(const Eigen::Vector2d& at_m)> on_box = nullptr;
  std::function<void(double for_s)> on_cut_cable = nullptr;
};

/// A person's hand on a robot that a strategy drives: takes commands from the queue and makes
/// motions of them, as long as the person has the robot. Silence and age are those of the wall
/// clock, which the caller reads: a person lives by it.
class OperatorControl {
 public:
  using WallTime = std::chrono::steady_clock::time_point;

  /// The queue outlives this.
  OperatorControl(OperatorQueue& queue, const OperatorParams& params, OperatorHooks hooks);

  /// Takes what waits; to be called after every step of time. True where the motion under way has
  /// to end at once.
  bool poll(WallTime now);
  bool has_robot() const { return mode_ != OperatorMode::kStrategy; }
  /// How often a person has taken the robot from the strategy.
  std::size_t times_taken() const { return times_taken_; }
  /// The next motion of a robot that the person has; `last` is how the one before ended, kTakenOver
  /// after one of the strategy's.
  exploration::Motion next(const pipeline::Snapshot& snapshot, exploration::MotionResult last);

  OperatorMode mode() const { return mode_; }
  StandReason reason() const { return reason_; }
  /// Where it was sent to, while it goes there.
  std::optional<Eigen::Vector2d> goal_m() const;

 private:
  void obey(const StopRobot& command);
  void obey(const SteerRobot& command);
  void obey(const ResumeStrategy& command);
  void obey(const GoTo& command);
  void obey(const ReportMoved& command);
  void obey(const PlaceRobot& command);
  void obey(const SetSpeed& command);
  void obey(const CarryOff& command);
  void obey(const PutBox& command);
  void obey(const CutCable& command);

  void take(OperatorMode mode);
  void stand(StandReason reason);
  exploration::Motion drive(exploration::MotionResult last);
  exploration::Motion go(const pipeline::Snapshot& snapshot, exploration::MotionResult last);
  bool plan(const pipeline::Snapshot& snapshot);

  OperatorQueue& queue_;
  OperatorParams params_;
  OperatorHooks hooks_;
  std::size_t times_taken_ = 0;
  WallTime now_;
  SteerRobot steer_;
  Eigen::Vector2d goal_m_ = Eigen::Vector2d::Zero();
  std::optional<exploration::Navigator> navigator_;
  OperatorMode mode_ = OperatorMode::kStrategy;
  StandReason reason_ = StandReason::kNone;
  bool ends_motion_ = false;  ///< What was taken since the last look ends the motion under way.
  bool is_blocked_ = false;   ///< It was stopped: nothing moves before the stick was let go.
  bool is_planned_ = false;   ///< The way to the goal.
};

}  // namespace echomap::session
