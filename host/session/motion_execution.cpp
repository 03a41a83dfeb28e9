// SPDX-License-Identifier: MIT
#include "host/session/motion_execution.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <variant>

#include "host/geometry/angle.hpp"

namespace echomap::session {
namespace {

using exploration::MotionResult;
using robot_link::CommandOutcome;
using std::chrono::milliseconds;
using std::chrono::seconds;
using Duration = RobotLine::Duration;

/// After a move, until the body has come to rest.
constexpr milliseconds kRest(150);
/// Of a look on the way, from side to side in 1.5 s.
constexpr double kMaxLookRad = std::numbers::pi / 2.0;
constexpr double kLookStepRad = std::numbers::pi / 12.0;
constexpr double kLookSettleS = 0.03;
/// The NXT's sonar measures by itself: its driver asks it every 100 ms.
constexpr double kSlowestAnswerS = 0.15;

Duration seconds_of(double value_s) { return Duration(std::llround(value_s * 1e6)); }

double radians_of_cdeg(std::int32_t cdeg) { return geometry::radians(0.01 * cdeg); }

std::int32_t centidegrees(double angle_rad) {
  return static_cast<std::int32_t>(std::lround(geometry::degrees(angle_rad) * 100.0));
}

protocol::StartSweep command_of(const exploration::Sweep& sweep) {
  return {0,
          centidegrees(sweep.from_rad),
          centidegrees(sweep.to_rad),
          centidegrees(sweep.step_rad),
          static_cast<std::uint16_t>(std::lround(sweep.settle_s * 1e3))};
}

/// What a command that was not accepted means for the motion. `hazards` are those that stop the
/// wheels.
MotionResult refusal_of(CommandOutcome outcome, int hazards) {
  switch (outcome) {
    case CommandOutcome::kBlocked:
      return hazards != 0 ? MotionResult::kHazard : MotionResult::kBumped;
    case CommandOutcome::kLinkLost:
    case CommandOutcome::kRobotReset:
    case CommandOutcome::kDisarmed:
      return MotionResult::kInterrupted;
    default:
      return MotionResult::kRefused;
  }
}

}  // namespace

MotionResult MotionExecution::move(const sensors::WheelTicks& ticks) {
  const auto longest = std::max(std::abs(ticks.left), std::abs(ticks.right));
  const double ramp_s =
      2.0 * profile_.ticks_per_s() / profile_.configuration.drive.max_ticks_per_s2;
  const double expected_s = static_cast<double>(longest) / profile_.ticks_per_s() + ramp_s;

  if ((may_still_move_ && !stop()) || is_halted_) {
    return MotionResult::kInterrupted;
  }
  look_around();
  if (is_halted_) {
    return stop_halted();
  }
  line_.keep_alive(true);
  const MotionResult result = finish(
      protocol::MoveTicks{
          0, ticks.left, ticks.right, profile_.ticks_per_s(), line_.time_to_live_ms()},
      seconds_of(expected_s));
  line_.wait_until([] { return false; }, kRest);
  line_.keep_alive(false);
  return result;
}

MotionResult MotionExecution::stand(const exploration::Stand& stand) {
  if (may_still_move_ && !stop()) {
    return MotionResult::kInterrupted;
  }
  line_.wait_until([&] { return is_halted_; }, seconds_of(stand.for_s));
  return is_halted_ ? MotionResult::kInterrupted : MotionResult::kReached;
}

/// At once, and not behind the answer to a command that is under way.
void MotionExecution::halt() {
  is_halted_ = true;
  line_.keep_alive(false);
  line_.drive({0, 0});
}

MotionResult MotionExecution::sweep(const exploration::Sweep& sweep) {
  if (((may_still_move_ || may_still_look_) && !stop()) || is_halted_) {
    return MotionResult::kInterrupted;
  }
  return finish(command_of(sweep), seconds_of(duration_s(sweep)));
}

void MotionExecution::look_around() {
  if (!looks_on_the_way_ || is_looking()) {
    return;
  }
  const protocol::ConfigurePan& pan = profile_.configuration.pan;
  const double right_rad = std::max(radians_of_cdeg(pan.min_cdeg), -kMaxLookRad);
  const double left_rad = std::min(radians_of_cdeg(pan.max_cdeg), kMaxLookRad);
  const exploration::Sweep look =
      looks_from_left_ ? exploration::Sweep{left_rad, right_rad, -kLookStepRad, kLookSettleS}
                       : exploration::Sweep{right_rad, left_rad, kLookStepRad, kLookSettleS};
  const auto result = line_.perform(command_of(look));
  if (result && result->outcome == CommandOutcome::kAccepted) {
    look_id_ = result->command_id;
    looks_until_ = line_.now() + seconds_of(duration_s(look));
    looks_from_left_ = !looks_from_left_;
    may_still_look_ = true;
  }
  if (result && result->outcome == CommandOutcome::kOutOfRange) {
    looks_on_the_way_ = false;  // This pan cannot.
  }
}

bool MotionExecution::is_looking() const {
  const auto status = line_.status_since_answer();
  const bool is_over = status && status->sweep_id == look_id_ &&
                       static_cast<protocol::MotionOutcome>(status->sweep_outcome) !=
                           protocol::MotionOutcome::kRunning;
  return may_still_look_ && !is_over && line_.now() < looks_until_;
}

MotionResult MotionExecution::roll(const exploration::Roll& roll) {
  const bool was_touching = line_.hazards().is_touching();
  const int hazards_before = stopping_hazards();
  const auto met = [&] { return line_.hazards().is_touching() && !was_touching; };
  const auto endangered = [&] { return (stopping_hazards() & ~hazards_before) != 0; };
  const auto heard = [&] {
    return !line_.was_reset() && line_.link().state() == robot_link::LinkState::kReady;
  };
  if (is_halted_) {
    return stop_halted();
  }
  may_still_move_ = true;
  line_.drive(profile_.geometry.arc_speeds(roll.forward_m_per_s, roll.turn_rad_per_s));
  line_.keep_alive(true);
  look_around();
  line_.wait_until([&] { return met() || endangered() || !heard() || has_stalled() || is_halted_; },
                   seconds_of(roll.for_s));
  line_.keep_alive(false);
  if (is_halted_) {
    return stop_halted();
  }
  if (line_.hazards().lifted) {
    return MotionResult::kLifted;
  }
  if (!heard()) {
    return MotionResult::kInterrupted;
  }
  if (has_stalled()) {
    return stop() ? MotionResult::kStalled : MotionResult::kInterrupted;
  }
  return met()          ? MotionResult::kBumped
         : endangered() ? MotionResult::kHazard
                        : MotionResult::kReached;
}

bool MotionExecution::has_stalled() const {
  const auto& status = line_.status();
  return status &&
         status->move_outcome == static_cast<std::uint8_t>(protocol::MotionOutcome::kStalled);
}

/// From the far end of the pan to the first angle, and then at each angle until the pan has settled
/// and the ping is over.
double MotionExecution::duration_s(const exploration::Sweep& sweep) const {
  const protocol::ConfigurePan& pan = profile_.configuration.pan;
  const protocol::ConfigureSonar& sonar = profile_.configuration.sonar;
  const double swept_rad = std::abs(sweep.to_rad - sweep.from_rad);
  const double pings = swept_rad / std::abs(sweep.step_rad) + 1.0;
  const double way_deg = 0.01 * (pan.max_cdeg - pan.min_cdeg) + geometry::degrees(swept_rad);
  const double answer_s = std::max(1e-6 * sonar.max_echo_us, kSlowestAnswerS);
  const double ping_s = answer_s + 1e-3 * sonar.ping_gap_ms;
  return way_deg / pan.deg_per_s + pings * (sweep.settle_s + ping_s);
}

/// Sends the command and waits until the robot's Status says that its motion has ended.
MotionResult MotionExecution::finish(const robot_link::Command& command, Duration expected) {
  const auto result = line_.perform(command);
  may_still_move_ = !result || result->outcome == CommandOutcome::kLinkLost;
  if (!result || result->outcome != CommandOutcome::kAccepted) {
    return result ? refusal_of(result->outcome, stopping_hazards()) : MotionResult::kInterrupted;
  }
  const bool is_sweep = std::holds_alternative<protocol::StartSweep>(command);
  const auto outcome = [&] {
    const auto status = line_.status_since_answer();
    const bool ours =
        status && (is_sweep ? status->sweep_id : status->move_id) == result->command_id;
    return ours ? static_cast<protocol::MotionOutcome>(is_sweep ? status->sweep_outcome
                                                                : status->move_outcome)
                : protocol::MotionOutcome::kRunning;
  };
  const auto ended = [&] {
    return line_.was_reset() || is_halted_ || outcome() != protocol::MotionOutcome::kRunning;
  };
  if (!line_.wait_until(ended, 2 * expected + seconds(3))) {
    const bool was_heard = line_.link().state() == robot_link::LinkState::kReady;
    may_still_move_ = true;
    return was_heard && stop() ? MotionResult::kTimedOut : MotionResult::kInterrupted;
  }
  if (is_halted_) {
    return stop_halted();
  }
  return line_.was_reset() ? MotionResult::kInterrupted : result_of(outcome());
}

bool MotionExecution::stop() {
  const auto result = line_.perform(protocol::Stop{});
  may_still_move_ = !result || result->outcome != CommandOutcome::kAccepted;
  may_still_look_ = may_still_look_ && may_still_move_;
  return !may_still_move_;
}

MotionResult MotionExecution::stop_halted() {
  stop();
  return MotionResult::kInterrupted;
}

int MotionExecution::stopping_hazards() const {
  const auto& status = line_.status();
  return status ? status->hazards & profile_.configuration.safety.hazard_stops : 0;
}

MotionResult MotionExecution::result_of(protocol::MotionOutcome outcome) {
  line_.end_for_safety(outcome);
  switch (outcome) {
    case protocol::MotionOutcome::kReached:
      return MotionResult::kReached;
    case protocol::MotionOutcome::kBumped:
      return MotionResult::kBumped;
    case protocol::MotionOutcome::kHazard:
      return MotionResult::kHazard;
    case protocol::MotionOutcome::kStalled:
      return MotionResult::kStalled;
    case protocol::MotionOutcome::kLifted:
      return MotionResult::kLifted;
    case protocol::MotionOutcome::kExpired:
    case protocol::MotionOutcome::kNone:
      return MotionResult::kInterrupted;
    default:
      return MotionResult::kTimedOut;
  }
}

}  // namespace echomap::session
