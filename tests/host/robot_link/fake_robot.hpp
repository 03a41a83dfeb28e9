// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

#include "protocol/configuration.hpp"
#include "protocol/frame_encoder.hpp"
#include "protocol/link.hpp"
#include "protocol/messages.hpp"
#include "protocol/version.hpp"

namespace echomap::robot_link {

/// The robot's end of the wire with no robot behind it: answers Hello and commands as the firmware
/// does, streams telemetry, and notes what it was told. Built from protocol/ alone.
class FakeRobot {
 public:
  using Bytes = std::vector<std::uint8_t>;

  /// Starts again: forgets sessions and commands, clock and sequence at zero. Says so with session
  /// 0 when it `announces_boot`; refuses moves until the next Hello.
  void power_on(std::uint16_t boot_id, std::uint8_t reset_cause = protocol::kResetPowerOn);

  void receive(std::span<const std::uint8_t> bytes);
  /// Sends Odometry every 20 ms Status and Health every 200 ms of its own time; call it once a
  /// millisecond.
  void advance_1ms();
  Bytes take_outgoing();
  /// Its clock goes on, and nobody listens.
  void run_unheard_ms(int ms) { stamp_us_ += 1000U * static_cast<std::uint32_t>(ms); }

  template <class Message>
  void send(const Message& message) {
    const protocol::ByteSpan frame = encoder_.encode(message, next_seq_++);
    outgoing_.insert(outgoing_.end(), frame.data, frame.data + frame.size);
  }
  void send_bytes(const Bytes& bytes) {
    outgoing_.insert(outgoing_.end(), bytes.begin(), bytes.end());
  }

  /// What another host does.
  template <class Message>
  void hear_of_another(const Message& message) {
    if (!std::is_same_v<Message, protocol::Hello>) {
      filter_.hear();
    }
    handle(message);
  }
  std::uint16_t session() const { return filter_.session(); }

  static Bytes described_messages();

  std::uint32_t stamp_us() const { return stamp_us_; }

  // How it behaves.
  bool announces_boot = true;
  bool needs_arming = false;  ///< Moves only then.
  bool streams_before_hello = false;
  bool acknowledges = true;
  bool answers_pings = true;
  std::uint8_t protocol_major = 1;
  std::uint8_t protocol_minor = protocol::kProtocolMinor;
  std::uint32_t schema_digest = protocol::kSchemaDigest;
  std::uint16_t receive_credit_bytes = 128;
  std::uint32_t capabilities = 0;
  /// The description of its messages; by default those of this build.
  Bytes schema = described_messages();
  bool answers_bulk_reads = true;
  /// Firmware of before protocol 1.3 does not hold ConfigureWiring, nor hear it.
  bool holds_wiring = true;
  bool holds_scalar = true;  ///< False with holds_wiring, too.
  /// Added to what it was told of the pan's far end: a robot that does not do what it accepts.
  int pan_error_cdeg = 0;
  std::uint8_t hazards = 0;
  protocol::CommandStatus answer = protocol::CommandStatus::kAccepted;
  /// How moves and sweeps end, `motion_ms` after they were accepted.
  protocol::MotionOutcome outcome = protocol::MotionOutcome::kReached;
  int motion_ms = 100;

  // What it was told.
  int hellos = 0;
  int pings = 0;
  std::vector<std::int32_t> moves_done;  ///< `left_ticks` of each MoveTicks, in order.
  std::vector<protocol::KeepAlive> keep_alives;
  std::vector<protocol::DriveSetpoint> setpoints;
  std::vector<std::uint8_t> command_ids_received;
  protocol::Configuration configuration{};
  int configurations = 0;  ///< Messages of a configuration that were taken.
  int bulk_reads = 0;
  int sweeps = 0;  ///< That were begun.
  bool armed = false;
  /// Called with each command's name before it is carried out.
  std::function<void(std::string_view)> on_command;

 private:
  void take(const protocol::Frame& frame);
  void handle(const protocol::Hello& hello);
  void handle(const protocol::TakeOver& take_over) { begin_session(take_over.session); }
  void begin_session(std::uint16_t session);
  /// Of the messages that it holds.
  Bytes configuration_bytes() const;
  void reply(std::uint16_t session);
  void handle(const protocol::KeepAlive& message) { keep_alives.push_back(message); }
  void handle(const protocol::DriveSetpoint& message) { setpoints.push_back(message); }
  void handle(const protocol::Ping& ping);
  void handle(const protocol::BulkRead& read);
  Bytes bulk_content(std::uint8_t content) const;
  template <class Command>
  void handle(const Command& command);
  protocol::CommandStatus carry_out(const protocol::MoveTicks& move);
  protocol::CommandStatus carry_out(const protocol::StartSweep& sweep);
  protocol::CommandStatus carry_out(const protocol::Stop& stop);
  protocol::CommandStatus carry_out(const protocol::Arm& arm);
  template <class Settings>
  protocol::CommandStatus take_settings(Settings& held, const Settings& settings);
  protocol::CommandStatus carry_out(const protocol::ConfigureDrive& settings) {
    return take_settings(configuration.drive, settings);
  }
  protocol::CommandStatus carry_out(const protocol::ConfigureSonar& settings) {
    return take_settings(configuration.sonar, settings);
  }
  protocol::CommandStatus carry_out(const protocol::ConfigurePan& settings) {
    return take_settings(configuration.pan, settings);
  }
  protocol::CommandStatus carry_out(const protocol::ConfigurePins& settings) {
    return take_settings(configuration.pins, settings);
  }
  protocol::CommandStatus carry_out(const protocol::ConfigureSensors& settings) {
    return take_settings(configuration.sensors, settings);
  }
  protocol::CommandStatus carry_out(const protocol::ConfigureSafety& settings) {
    return take_settings(configuration.safety, settings);
  }
  protocol::CommandStatus carry_out(const protocol::ConfigureWiring& settings) {
    return take_settings(configuration.wiring, settings);
  }
  void end_motions(protocol::MotionOutcome end);
  template <class Command>
  protocol::CommandStatus carry_out(const Command& /*command*/) {
    return answer;
  }

  protocol::FrameDecoder decoder_{protocol::MessagesToRobot::find_schema};
  protocol::FrameEncoder encoder_;
  protocol::ReceiveCounters counters_;
  protocol::CommandFilter filter_;
  Bytes outgoing_;
  std::uint8_t next_seq_ = 0;
  std::uint32_t stamp_us_ = 0;
  std::uint16_t boot_id_ = 1;
  std::uint8_t reset_cause_ = protocol::kResetPowerOn;
  bool greeted_ = false;
  protocol::Status status_{};
  int motion_left_ms_ = 0;
};

}  // namespace echomap::robot_link
