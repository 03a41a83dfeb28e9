// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "host/apps/exit_code.hpp"
#include "host/apps/robot_connection.hpp"
#include "host/apps/robot_profile.hpp"
#include "host/exploration/explorer.hpp"
#include "host/pipeline/robot_pipeline.hpp"
#include "host/robot_link/robot_link.hpp"
#include "host/sensors/observation_converter.hpp"

namespace echomap::apps {

/// Why a session cannot go on.
enum class SessionEnd : std::uint8_t {
  kInterrupted,
  kLinkLost,
  kSafetyStop,  ///< The board has stopped and disarmed by itself.
};

/// What the shell sees of it.
ExitCode exit_code_of(SessionEnd end);

/// A robot that answers: feeds its observations to the pipeline and carries out motions. When the
/// board is reset or its line breaks, the session waits, sets the robot up again and goes on. Every
/// call that waits lets the session's time pass; nothing here reads a clock.
class RobotSession final : private robot_link::RobotLinkListener {
 public:
  /// `session_id` tells this session's commands from an earlier one's. `pipeline` outlives the
  /// session.
  RobotSession(RobotConnection robot,
               const RobotProfile& profile,
               pipeline::RobotPipeline& pipeline);
  /// Disarms, however the session ends.
  ~RobotSession() override;
  RobotSession(const RobotSession&) = delete;
  RobotSession& operator=(const RobotSession&) = delete;

  /// Says Hello, sends the profile, arms. Throws CommandError: 3 where no robot answers (with what
  /// came instead) or where it was reset and must not have been, 4 where its firmware is another,
  /// 5, 6 or 130.
  void connect();

  /// Carries out one motion and waits for its end; BeginScan and EndScan only tell the pipeline.
  /// Waits for a link that is away first. After `end()` is set the answer means nothing.
  exploration::MotionResult execute(const exploration::Motion& motion);

  /// Stops and disarms, where the robot still hears it; the second time does nothing.
  void disarm();

  /// Set once the user interrupted or the link was lost for good.
  std::optional<SessionEnd> end() const { return end_; }
  /// For people: why, in a sentence.
  const std::string& end_reason() const { return end_reason_; }

  /// Called after every step of time.
  std::function<void()> on_step;

  time::HostTime now() const { return now_; }
  const robot_link::RobotLink& link() const { return link_; }

 private:
  using Duration = time::HostClock::duration;

  void on_odometry(const protocol::Odometry& message) override;
  void on_echo(const protocol::Echo& message) override;
  void on_status(const protocol::Status& message) override;
  void on_health(const protocol::Health& message) override;
  void on_ranges(const protocol::Ranges& message) override;
  void on_gyro(const protocol::Gyro& message) override;
  void on_bulk(const robot_link::BulkResult& result) override { bulk_ = result; }
  void on_ready(const protocol::HelloReply& reply) override;
  void on_reset(std::uint8_t reset_cause) override;
  void on_command_done(const robot_link::CommandResult& result) override;

  void step();
  void look_for_end();
  void end(SessionEnd end, const std::string& reason);
  /// Steps until `done`, until `limit` of session time has passed or until the session ends; true
  /// when done.
  bool wait_until(const std::function<bool()>& done, Duration limit);
  void check_it_was_not_reset();
  /// Waits for the link and sets the robot up where it has started anew; false at the session's
  /// end.
  bool be_ready();
  bool set_up_robot();
  bool try_to_set_up();
  /// Brings the board to the profile's configuration and reads it back; false where the board was
  /// reset, or the link lost, in between.
  bool configure();
  bool send_configuration(const robot_link::Command& command);
  std::optional<protocol::Configuration> read_configuration();
  /// Also ends the session where the board has disarmed by itself.
  exploration::MotionResult result_of(protocol::MotionOutcome outcome);
  void end_for_safety(protocol::MotionOutcome outcome);

  std::optional<robot_link::CommandResult> perform(const robot_link::Command& command);
  exploration::MotionResult move(const sensors::WheelTicks& ticks);
  exploration::MotionResult sweep(const exploration::Sweep& sweep);
  exploration::MotionResult finish(const robot_link::Command& command, Duration expected);

  std::unique_ptr<transport::ByteStream> stream_;
  std::unique_ptr<Pace> pace_;
  Duration patience_;
  bool no_reset_;
  std::uint16_t time_to_live_ms_;
  RobotProfile profile_;
  pipeline::RobotPipeline& pipeline_;
  sensors::ObservationConverter converter_;
  robot_link::RobotLink link_;

  time::HostTime now_;
  std::uint64_t bytes_sent_ = 0;
  bool connected_ = false;
  bool disarmed_ = false;
  std::optional<time::HostTime> away_since_;  ///< While the link is not ready.
  std::optional<SessionEnd> end_;
  std::string end_reason_;

  std::optional<protocol::Status> status_;
  std::optional<robot_link::CommandResult> result_;
  std::optional<robot_link::BulkResult> bulk_;
  unsigned resets_ = 0;
};

}  // namespace echomap::apps
