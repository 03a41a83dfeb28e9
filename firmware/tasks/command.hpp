// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "firmware/control/fixed_point.hpp"
#include "firmware/control/scan_sweep.hpp"
#include "firmware/control/wheel_motion.hpp"
#include "firmware/tasks/bulk.hpp"
#include "firmware/tasks/frame_sender.hpp"
#include "firmware/tasks/safety.hpp"
#include "firmware/tasks/telemetry.hpp"
#include "protocol/configuration.hpp"
#include "protocol/link.hpp"

namespace echomap {
namespace tasks {

/// What commands act upon.
struct CommandTargets {
  drivers::SerialPort& port;
  FrameSender& sender;
  control::WheelMotion& motion;
  control::ScanSweep& sweep;
  Sensors& sensors;
  Safety& safety;
  Telemetry& telemetry;
  protocol::ReceiveCounters& received;
  protocol::Configuration& configuration;
  Bulk& bulk;
};

/// Takes the host's bytes apart and does what they say: commands exactly once, each answered by an
/// Ack; set-points without one, the latest wins.
class Command {
 public:
  /// Bytes per call of `poll`, so that no call takes long.
  static constexpr uint8_t kBytesPerPoll = 16;

  constexpr explicit Command(const CommandTargets& targets) : targets_(targets) {}

  /// Tells the host, unasked, that the robot has just started: HelloReply with session 0.
  void announce();
  /// Works on received bytes; false when there were none.
  bool poll();
  /// Once in a control period: a session that falls silent loses the robot in the end.
  void control() { filter_.pass(control::kControlPeriodMs); }

  /// One for each message of protocol::MessagesToRobot, called by the dispatcher.
  void operator()(const protocol::Hello& hello);
  void operator()(const protocol::TakeOver& take_over);
  void operator()(const protocol::Ping& ping);
  void operator()(const protocol::DriveSetpoint& setpoint);
  void operator()(const protocol::KeepAlive& keep_alive);
  void operator()(const protocol::BulkRead& read);
  template <class CommandMessage>
  void operator()(const CommandMessage& command) {
    static_assert(is_command(CommandMessage::kId), "its command_id was checked by its id");
    filter_.remember(command.command_id, execute(command));
    targets_.sender.answer(filter_.answer());
  }

 private:
  /// Commands have the ids 0x10 .. 0x1F, and their command_id in front.
  static constexpr bool is_command(uint8_t id) { return (id & 0xF0) == 0x10; }
  void end_frame(protocol::DecodeStatus status);
  void begin_session(uint16_t session);
  /// A Hello while another session holds the robot, which must not notice it.
  bool is_foreign_hello(const protocol::Frame& frame) const;
  void reply(uint16_t session);
  /// Nothing moves any more, nor the sonar.
  void disarm();
  /// False for a command that must not be done, which is answered right away: a repeated one, one
  /// without an id, and any before the first Hello.
  bool is_new(uint8_t command_id);
  protocol::CommandStatus execute(const protocol::Arm& command);
  protocol::CommandStatus execute(const protocol::Stop& command);
  protocol::CommandStatus execute(const protocol::ConfigureDrive& command);
  /// Gives `target` its settings, unless it is busy with the old ones.
  template <class Target, class Settings>
  static protocol::CommandStatus configure(Target& target, const Settings& settings, bool busy);
  protocol::CommandStatus execute(const protocol::ConfigurePan& command);
  protocol::CommandStatus execute(const protocol::ConfigureSonar& command);
  protocol::CommandStatus execute(const protocol::ConfigurePins& command);
  protocol::CommandStatus execute(const protocol::ConfigureSensors& command);
  protocol::CommandStatus execute(const protocol::ConfigureSafety& command);
  protocol::CommandStatus execute(const protocol::ConfigureWiring& command);
  protocol::CommandStatus execute(const protocol::ConfigureScalar& command);
  protocol::CommandStatus execute(const protocol::MoveTicks& command);
  protocol::CommandStatus execute(const protocol::StartSweep& command);

  CommandTargets targets_;
  protocol::FrameDecoder decoder_{protocol::MessagesToRobot::find_schema};
  protocol::CommandFilter filter_;
  bool greeted_ = false;
};

}  // namespace tasks
}  // namespace echomap
