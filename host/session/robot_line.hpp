// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "host/pipeline/observation_sink.hpp"
#include "host/robot_link/robot_link.hpp"
#include "host/sensors/robot_geometry.hpp"
#include "host/session/line_recorder.hpp"
#include "host/session/observation_feed.hpp"
#include "host/session/robot_connection.hpp"
#include "host/session/robot_profile.hpp"
#include "host/session/session_end.hpp"

namespace echomap::session {

/// The robot at the end of its line: lets the session's time pass, waits for the robot's answers
/// and notices when it can be waited for no longer. Nothing here reads a clock.
class RobotLine final : private robot_link::RobotLinkListener {
 public:
  using Duration = time::HostClock::duration;

  /// `sink` outlives the line.
  RobotLine(RobotConnection robot, const RobotProfile& profile, pipeline::ObservationSink& sink);
  RobotLine(const RobotLine&) = delete;
  RobotLine& operator=(const RobotLine&) = delete;

  /// Lets a first step of time pass, from which on limits count: the pace may have begun long
  /// before, as when a port was looked for.
  void begin();
  /// Lets time pass until `done`, for `limit` at most or until the session ends; true when done.
  bool wait_until(const std::function<bool()>& done, Duration limit);
  /// Waits for a ready link for as long as the connection's patience allows, and for a robot that
  /// may be lifted until it stands, five minutes at most; false at the session's end.
  bool wait_until_ready();
  /// Sends a command and waits for its outcome; empty where none came.
  std::optional<robot_link::CommandResult> perform(const robot_link::Command& command);
  /// Reads a bulk content; empty where it did not come, as after a reset.
  std::optional<robot_link::BulkResult> read(protocol::BulkContent content);
  /// Sends wheel speeds, which the robot follows for its time to live or until the next.
  void drive(const sensors::WheelTicks& ticks_per_s);
  /// While on, motion on the robot is kept alive.
  void keep_alive(bool on) { link_.keep_alive(on); }
  /// How long motion outlives the last that was heard from the host.
  std::uint16_t time_to_live_ms() const { return time_to_live_ms_; }

  /// From now on a link that is away for longer than the connection's patience ends the session, as
  /// do other firmware, another program that has the robot, and a robot that is lifted where it may
  /// not be.
  void hold_on() { is_held_ = true; }
  /// Stops and disarms, where a robot that was held still hears it, even after the end; the second
  /// time does nothing. To go on it has to be set up again.
  void disarm();

  /// Nothing is waited for any more. The first end counts.
  void end(SessionEnd end, const std::string& reason);
  /// Ends the session where a motion that ended so has disarmed the board; one that may be lifted
  /// has to be set up again.
  void end_for_safety(protocol::MotionOutcome outcome);
  std::optional<SessionEnd> end() const { return end_; }
  /// For people: why, in a sentence.
  const std::string& end_reason() const { return end_reason_; }

  /// Since the last `forget_resets` the robot has started anew, was lifted or was found to be
  /// disarmed, as another host's Hello does it: it has to be set up again.
  bool was_reset() const { return was_reset_; }
  void forget_resets() {
    was_reset_ = false;
    disarmed_ = false;
  }
  /// The last since the robot's start; empty before the first.
  const std::optional<protocol::Status>& status() const { return status_; }
  /// The last that came behind the answer to the last command; empty before. An earlier one may
  /// tell of a motion of another session, whose command had the same id.
  std::optional<protocol::Status> status_since_answer() const;
  /// What touches or threatens the robot, as it was told last.
  const sensors::HazardObservation& hazards() const { return observations_.hazards(); }

  /// The robot's stamp of the last odometry since its start; empty before the first.
  std::optional<std::uint32_t> odometry_stamp_us() const { return odometry_stamp_us_; }

  std::string name() const { return stream_->name(); }
  /// How often the port was opened again.
  std::uint64_t reconnects() const { return stream_->reconnects(); }
  time::HostTime now() const { return now_; }
  const robot_link::RobotLink& link() const { return link_; }

  /// Called after every step of time.
  std::function<void()> on_step;

 private:
  void on_odometry(const protocol::Odometry& message) override;
  void on_echo(const protocol::Echo& message) override { observe(message); }
  void on_status(const protocol::Status& message) override;
  void on_health(const protocol::Health& message) override;
  void on_ranges(const protocol::Ranges& message) override { observe(message); }
  void on_gyro(const protocol::Gyro& message) override { observe(message); }
  void on_encoder_errors(const protocol::EncoderErrors& message) override { observe(message); }
  void on_scalar(const protocol::Scalar& message) override { observe(message); }
  void on_bulk(const robot_link::BulkResult& result) override { bulk_ = result; }
  void on_ready(const protocol::HelloReply& reply) override;
  void on_reset(std::uint8_t reset_cause) override;
  void on_command_done(const robot_link::CommandResult& result) override;

  /// The stream is open and time passes.
  bool goes_on() const;
  template <class Telemetry>
  void observe(const Telemetry& message) {
    recorder_.use(message.stamp_us);
    observations_.take(message);
  }
  void step();
  void look_for_end();
  void look_for_absence();
  void look_for_lift();
  std::string reason_of_absence() const;

  std::unique_ptr<transport::ByteStream> stream_;
  std::unique_ptr<Pace> pace_;
  Duration patience_;
  bool may_be_lifted_;
  bool reset_loses_pan_;  ///< A stepper takes where it stands at its start for straight ahead.
  std::uint16_t time_to_live_ms_;
  ObservationFeed observations_;
  robot_link::RobotLink link_;
  LineRecorder recorder_;

  time::HostTime now_;
  std::uint64_t bytes_sent_ = 0;
  bool is_held_ = false;
  bool disarmed_ = false;
  std::optional<time::HostTime> away_since_;  ///< While the link is not ready.
  bool absence_is_told_ = false;
  std::optional<time::HostTime> lifted_since_;  ///< While a robot that may be is lifted.
  std::optional<SessionEnd> end_;
  std::string end_reason_;

  std::optional<protocol::Status> status_;
  std::optional<std::uint32_t> status_at_answer_us_;  ///< Stamp of the last before an answer.
  std::optional<std::uint32_t> odometry_stamp_us_;
  time::HostTime odometry_at_;  ///< When the last odometry came.
  std::optional<robot_link::CommandResult> result_;
  std::optional<robot_link::BulkResult> bulk_;
  bool was_reset_ = false;
  bool is_lifted_ = false;
};

}  // namespace echomap::session
