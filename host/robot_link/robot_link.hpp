// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "host/robot_link/bulk_reader.hpp"
#include "host/robot_link/command_sender.hpp"
#include "host/robot_link/frame_inbox.hpp"
#include "host/robot_link/frame_outbox.hpp"
#include "host/robot_link/line_watch.hpp"
#include "host/robot_link/link_state.hpp"
#include "host/robot_link/link_statistics.hpp"
#include "host/robot_link/outage_counter.hpp"
#include "host/robot_link/ping_sender.hpp"
#include "host/robot_link/protocol_mismatch.hpp"
#include "host/robot_link/robot_identification.hpp"
#include "host/robot_link/robot_link_listener.hpp"
#include "host/robot_link/robot_link_params.hpp"
#include "host/robot_link/robot_schema.hpp"
#include "host/robot_link/setpoint_slot.hpp"
#include "host/robot_link/telemetry_feed.hpp"
#include "host/time/clock_sync.hpp"
#include "host/time/host_time.hpp"
#include "protocol/messages.hpp"

namespace echomap::robot_link {

/// The host's end of the wire without the wire: bytes and instants in, messages and bytes out. It
/// shakes hands, notices resets, sends commands until they are answered and says how the link is.
/// It owns no port and no clock, so it runs the same on a desk, in simulated time and in tests.
class RobotLink {
 public:
  /// `session` is not 0 (a robot that announces its start says 0) and must differ from that of the
  /// last host that spoke to this robot: the robot forgets earlier command ids when it changes.
  /// `listener` outlives the link. Throws std::invalid_argument for session 0 and where the periods
  /// do not fit together.
  RobotLink(RobotLinkListener& listener, std::uint16_t session, const RobotLinkParams& params = {});

  /// Takes bytes from the robot, in any pieces; calls the listener from within.
  void receive(std::span<const std::uint8_t> bytes, time::HostTime now);

  /// Sends what is due: Hello, KeepAlive, commands and their resends; ends commands that found no
  /// answer. Call it every 10 ms or so of host time, and after `receive`.
  void poll(time::HostTime now);

  /// The bytes to write to the robot since the last call.
  std::vector<std::uint8_t> take_outgoing() { return outbox_.take_outgoing(); }

  /// Queues a command; `on_command_done` brings the outcome. While the link is connecting it waits;
  /// where the link is silent, garbage, unheard, lost or a mismatch it ends in kLinkLost at the
  /// next `poll`.
  CommandTicket submit(const Command& command) { return commands_.submit(command); }

  /// Sends wheel speeds now, never again; dropped unless the link is ready. While the robot's
  /// credit is used up the latest waits, for its own time to live at most.
  void send(const protocol::DriveSetpoint& setpoint, time::HostTime now);

  /// Asks a ready robot for a bulk content; `on_bulk` brings it whole, or says why not. A reading
  /// under way is given up without a word.
  void read(protocol::BulkContent content);

  /// While on, motion on the robot is kept alive; off, it ends within `keep_alive_ttl`.
  void keep_alive(bool on) { keep_alive_ = on; }

  LinkState state() const { return state_; }
  LinkStatistics statistics() const;
  /// Where the robot's stamps lie on the host's clock; starts again after a reset and after an
  /// outage of more than its window.
  const time::ClockSync& clock() const { return clock_; }
  /// Of the telemetry since the link became ready; empty before the first.
  std::optional<std::uint32_t> newest_stamp_us() const { return telemetry_.newest_stamp_us(); }
  /// What the robot said of itself in its last reply; empty before the first.
  const std::optional<protocol::HelloReply>& robot() const { return identification_.robot(); }
  /// In what the messages of a robot differ that is spoken to all the same; empty where they do
  /// not.
  const std::optional<SchemaDifference>& difference() const { return identification_.difference(); }
  /// The session that holds the robot, in state kBusy.
  std::uint16_t holder() const { return holder_; }
  /// Both versions, in state kMismatch.
  const std::optional<ProtocolMismatch>& mismatch() const { return identification_.mismatch(); }
  /// What came instead of frames, in state kGarbage.
  const BytePreview& preview() const { return inbox_.preview(); }

 private:
  void take_byte(std::uint8_t byte);

  void handle(const protocol::HelloReply& reply);
  void handle(const protocol::Ack& ack);
  void handle(const protocol::Pong& pong);
  void handle(const protocol::BulkData& data);
  template <class Telemetry>
  void handle(const Telemetry& message);

  /// The robot has answered another session's Hello, or ours with the name of another.
  void notice_holder(const protocol::HelloReply& reply);
  void notice_reset(const protocol::HelloReply& reply);
  void act_on(RobotIdentity identity, const protocol::HelloReply& robot);
  void take_description(const BulkResult& result);
  void end_reading();

  void search_again();
  void send_hello();
  void send_setpoint();
  void send_keep_alive();
  void send_ping();
  void send_command();
  void send_bulk();
  void end_commands(CommandOutcome outcome);

  RobotLinkListener& listener_;
  std::uint16_t session_;
  RobotLinkParams params_;

  LinkState state_ = LinkState::kConnecting;
  std::uint16_t holder_ = 0;
  RobotIdentification identification_;
  LineWatch watch_;
  TelemetryFeed telemetry_;

  FrameInbox inbox_;
  FrameOutbox outbox_;
  CommandSender commands_;
  SetpointSlot setpoint_;
  BulkReader bulk_;
  PingSender pings_;
  time::ClockSync clock_;
  OutageCounter outages_;
  LinkStatistics statistics_;

  time::HostTime now_;  ///< Of the `receive` or `poll` under way.
  time::HostTime next_keep_alive_;
  bool keep_alive_ = false;
  std::optional<time::HostTime> command_waits_since_;  ///< For credit.
};

}  // namespace echomap::robot_link
