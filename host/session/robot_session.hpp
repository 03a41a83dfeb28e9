// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "host/exploration/explorer.hpp"
#include "host/pipeline/observation_sink.hpp"
#include "host/robot_link/robot_link.hpp"
#include "host/session/motion_execution.hpp"
#include "host/session/robot_connection.hpp"
#include "host/session/robot_line.hpp"
#include "host/session/robot_profile.hpp"
#include "host/session/robot_setup.hpp"
#include "host/session/session_end.hpp"

namespace echomap::session {

/// A robot that answers: feeds its observations to a pipeline and carries out motions. When the
/// board is reset or its line breaks, the session waits, sets the robot up again and goes on. Every
/// call that waits lets the session's time pass; nothing here reads a clock.
class RobotSession {
 public:
  /// `sink` outlives the session.
  RobotSession(RobotConnection robot, const RobotProfile& profile, pipeline::ObservationSink& sink);
  /// Disarms, however the session ends; `on_step` is not called any more.
  ~RobotSession();
  RobotSession(const RobotSession&) = delete;
  RobotSession& operator=(const RobotSession&) = delete;

  /// Says Hello, sends the profile, arms. Throws CommandError: 3 where no robot answers (with what
  /// came instead), where another program holds it, or where it was reset and must not have been, 4
  /// where its firmware is another, 5, 6 or 130.
  void connect();

  /// Carries out one motion and waits for its end; BeginScan and EndScan only tell the pipeline.
  /// Waits for a link that is away first. After `end()` is set the answer means nothing.
  exploration::MotionResult execute(const exploration::Motion& motion);

  /// Ends the motion under way at once; to be called while it lets time pass.
  void halt() { motions_.halt(); }

  /// Whether the sonar looks around whenever a motion turns the wheels. What it hears comes to the
  /// pipeline like the readings of a sweep.
  void look_around_on_the_way(bool on) { motions_.look_around_on_the_way(on); }

  /// Ends a scan that is open, also where the robot is gone.
  void end_scan() { sink_.end_scan(); }

  /// Lets time pass until `done`, for `limit` at most or until the session ends.
  void wait_until(const std::function<bool()>& done, time::HostClock::duration limit) {
    line_.wait_until(done, limit);
  }

  /// Stops and disarms, where the robot still hears it; the second time does nothing. The next
  /// motion arms it again.
  void disarm() { line_.disarm(); }

  /// Set once nothing more can be done with the robot.
  std::optional<SessionEnd> end() const { return line_.end(); }
  /// For people: why, in a sentence.
  const std::string& end_reason() const { return line_.end_reason(); }

  /// Called after every step of time.
  std::function<void()> on_step;

  time::HostTime now() const { return line_.now(); }
  /// How often the port was opened again.
  std::uint64_t reconnects() const { return line_.reconnects(); }
  /// The robot's stamp of the last odometry since its start; empty before the first.
  std::optional<std::uint32_t> odometry_stamp_us() const { return line_.odometry_stamp_us(); }
  const robot_link::RobotLink& link() const { return line_.link(); }

 private:
  void throw_if_reset();
  /// Waits for the link and sets the robot up where it has started anew; false at the session's
  /// end.
  bool be_ready();
  exploration::MotionResult sweep(const exploration::Sweep& sweep);

  bool no_reset_;
  RobotProfile profile_;
  pipeline::ObservationSink& sink_;
  RobotLine line_;
  RobotSetup setup_;
  MotionExecution motions_;
};

}  // namespace echomap::session
