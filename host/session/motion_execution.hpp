// SPDX-License-Identifier: MIT
#pragma once

#include "host/exploration/explorer.hpp"
#include "host/robot_link/command.hpp"
#include "host/sensors/robot_geometry.hpp"
#include "host/session/robot_line.hpp"
#include "host/session/robot_profile.hpp"

namespace echomap::session {

/// Carries out one motion of an armed robot and waits for its end. Where the board has disarmed by
/// itself it ends the session.
class MotionExecution {
 public:
  /// Both outlive this.
  MotionExecution(RobotLine& line, const RobotProfile& profile) : line_(line), profile_(profile) {}

  /// Waits until the body has come to rest, too.
  exploration::MotionResult move(const sensors::WheelTicks& ticks);
  exploration::MotionResult sweep(const exploration::Sweep& sweep);
  /// Ends before its time where something new is touched or stops the wheels; they roll on
  /// behind it until the next motion, and for the line's time to live at most.
  exploration::MotionResult roll(const exploration::Roll& roll);
  /// Waits, for so long or until it is halted.
  exploration::MotionResult stand(const exploration::Stand& stand);
  /// Ends the motion under way at once: the wheels stop and the motion is kInterrupted, as is each
  /// one that begins before `let_go`.
  void halt();
  void let_go() { is_halted_ = false; }
  bool is_halted() const { return is_halted_; }
  /// Whether the sonar looks from one side to the other while the wheels turn, until the next
  /// sweep.
  void look_around_on_the_way(bool on) { looks_on_the_way_ = on; }

 private:
  void look_around();
  bool is_looking() const;
  exploration::MotionResult finish(const robot_link::Command& command,
                                   RobotLine::Duration expected);
  /// The wheels do not follow set-points; none does anything before a stop.
  bool has_stalled() const;
  /// False where the robot does not say that it stopped.
  bool stop();
  exploration::MotionResult stop_halted();
  double duration_s(const exploration::Sweep& sweep) const;
  int stopping_hazards() const;
  exploration::MotionResult result_of(protocol::MotionOutcome outcome);

  RobotLine& line_;
  const RobotProfile& profile_;
  /// The link was away when the last motion should have ended, or when it was sent: the robot,
  /// which may be busy with it, has to be stopped before the next.
  bool may_still_move_ = false;
  bool looks_on_the_way_ = false;
  /// The sonar may be busy with a look: it has to be stopped before the next sweep.
  bool may_still_look_ = false;
  std::uint8_t look_id_ = 0;     ///< The last look's, as in Status::sweep_id.
  time::HostTime looks_until_;   ///< At the latest, by what the profile says of the pan.
  bool looks_from_left_ = true;  ///< The next one.
  bool is_halted_ = false;
};

}  // namespace echomap::session
