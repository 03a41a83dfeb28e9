// SPDX-License-Identifier: MIT
#include "host/robot_link/robot_link.hpp"

#include <stdexcept>
#include <variant>

#include "protocol/version.hpp"

namespace echomap::robot_link {

using protocol::MessagesToHost;

RobotLink::RobotLink(RobotLinkListener& listener,
                     std::uint16_t session,
                     const RobotLinkParams& params)
    : listener_(listener),
      session_(session),
      params_(validated(params)),
      identification_(params.needed_messages),
      watch_(params),
      telemetry_(listener, params.max_step_back),
      outbox_(params.credit),
      commands_(params.retransmission, params.command_tries),
      bulk_(params.retransmission, params.bulk),
      pings_(params.ping),
      clock_(params.clock) {
  if (session == 0) {
    throw std::invalid_argument("robot link: session must not be 0");
  }
}

void RobotLink::receive(std::span<const std::uint8_t> bytes, time::HostTime now) {
  now_ = now;
  if (!bytes.empty()) {
    watch_.note_byte(now);
  }
  statistics_.bytes_received += bytes.size();
  for (const std::uint8_t byte : bytes) {
    take_byte(byte);
  }
}

void RobotLink::take_byte(std::uint8_t byte) {
  const InboxEvent event = inbox_.take(byte, identification_.difference());
  if (event == InboxEvent::kForeign) {
    watch_.note_frame(now_);
  }
  if (event != InboxEvent::kFrame) {
    return;
  }
  const protocol::Frame frame = inbox_.frame();
  // A robot that was reset unheard answers pings too, and only Hello finds that out.
  if (frame.id != protocol::Pong::kId) {
    watch_.note_frame(now_);
  }
  auto handler = [this](const auto& message) { handle(message); };
  protocol::Dispatcher<MessagesToHost>::dispatch(frame.id, frame.payload, handler);
  inbox_.count_frame();
}

void RobotLink::handle(const protocol::HelloReply& reply) {
  if (identification_.is_another_start(reply)) {
    notice_reset(reply);
  }
  if (reply.session != session_) {
    notice_holder(reply);
    return;
  }
  params_.takes_over = false;
  outbox_.confirm(reply);
  identification_.note(reply);
  if (state_ != LinkState::kReady && state_ != LinkState::kDescribing) {
    act_on(identification_.identify(reply), reply);
  }
}

void RobotLink::notice_holder(const protocol::HelloReply& reply) {
  // Before minor 3 a robot obeyed whoever said Hello last; 0 is one that has just started.
  constexpr std::uint8_t kFirstMinor = 3;
  const bool is_held = reply.session != 0 && reply.protocol_major == protocol::kProtocolMajor &&
                       reply.protocol_minor >= kFirstMinor;
  if (!is_held) {
    return;
  }
  search_again();
  state_ = LinkState::kBusy;
  holder_ = reply.session;
}

void RobotLink::act_on(RobotIdentity identity, const protocol::HelloReply& robot) {
  switch (identity) {
    case RobotIdentity::kUnderstood:
      state_ = LinkState::kReady;
      telemetry_.restart();
      telemetry_.take_capabilities(robot.capabilities);
      pings_.restart(now_);
      if (outages_.last() > params_.clock.window) {
        clock_.restart();  // Nothing that it knows counts any more, and stamps may have wrapped.
      }
      listener_.on_ready(robot);
      break;
    case RobotIdentity::kUndescribed:
      state_ = LinkState::kDescribing;
      bulk_.start(protocol::BulkContent::kSchema);
      break;
    case RobotIdentity::kRefused:
      state_ = LinkState::kMismatch;
      break;
  }
}

void RobotLink::take_description(const BulkResult& result) {
  const auto robot = identification_.robot();
  const bool is_lost = result.status == BulkStatus::kNoAnswer && watch_.is_lost(now_);
  if (!robot || is_lost) {
    state_ = LinkState::kLost;
    return;
  }
  act_on(identification_.identify(*robot, result), *robot);
}

void RobotLink::notice_reset(const protocol::HelloReply& reply) {
  identification_.note(reply);
  search_again();
  inbox_.restart();
  ++statistics_.resets_seen;
  telemetry_.restart_counters();
  clock_.restart();
  bulk_.abandon();
  end_reading();
  end_commands(CommandOutcome::kRobotReset);
  listener_.on_reset(reply.reset_cause);
}

void RobotLink::search_again() {
  state_ = LinkState::kConnecting;
  watch_.begin_search(now_);
}

void RobotLink::handle(const protocol::Ack& ack) {
  outbox_.confirm(ack);
  const auto result = commands_.acknowledge(ack, now_);
  if (!result) {
    return;
  }
  // A robot that was reset unheard, or heard another host's Hello, answers so too: ask it.
  if (result->outcome == CommandOutcome::kDisarmed && state_ == LinkState::kReady) {
    search_again();
  }
  listener_.on_command_done(*result);
}

void RobotLink::handle(const protocol::BulkData& data) {
  outbox_.confirm(data);
  bulk_.take_answer(data, now_);
  end_reading();
}

/// Hands on what has been read. What ended because of a reset is nobody's description.
void RobotLink::end_reading() {
  const auto result = bulk_.take_result();
  if (!result) {
    return;
  }
  if (state_ == LinkState::kDescribing) {
    take_description(*result);
  } else {
    listener_.on_bulk(*result);
  }
}

void RobotLink::read(protocol::BulkContent content) { bulk_.start(content); }

void RobotLink::handle(const protocol::Pong& pong) {
  outbox_.confirm(pong);
  const auto sent_at = state_ == LinkState::kReady ? pings_.take_answer(pong.token) : std::nullopt;
  if (sent_at) {
    clock_.add_ping(*sent_at, pong.stamp_us, now_);
  }
}

template <class Telemetry>
void RobotLink::handle(const Telemetry& message) {
  if (state_ != LinkState::kReady) {
    return;
  }
  if (!telemetry_.continues(message.stamp_us)) {
    search_again();
    return;
  }
  clock_.add_telemetry(message.stamp_us, now_);
  telemetry_.deliver(message);
}

void RobotLink::poll(time::HostTime now) {
  now_ = now;
  outbox_.credit().release_overdue(now);
  state_ = state_ == LinkState::kReady && commands_.is_exhausted(now)
               ? LinkState::kLost
               : watch_.next_state(state_, now);
  outages_.note(state_, now);
  if (watch_.is_hello_due(state_, now)) {
    send_hello();
  }
  if (state_ == LinkState::kReady) {
    send_keep_alive();
    send_command();
    send_ping();
    send_setpoint();
    send_bulk();
  } else if (state_ == LinkState::kDescribing) {
    send_bulk();
  } else if (state_ != LinkState::kConnecting) {
    bulk_.abandon();
    end_reading();
    end_commands(CommandOutcome::kLinkLost);
  }
}

void RobotLink::send_hello() {
  watch_.note_hello(now_);
  // Ends whatever a reset or an earlier host left unfinished in the robot's decoder.
  outbox_.put_delimiters(1, now_);
  if (state_ == LinkState::kBusy && params_.takes_over) {
    outbox_.put(protocol::TakeOver{session_}, now_);
    return;
  }
  outbox_.put(
      protocol::Hello{
          protocol::kProtocolMajor, protocol::kProtocolMinor, protocol::kSchemaDigest, session_},
      now_);
}

void RobotLink::send_setpoint() {
  setpoint_.drop_expired(now_);
  if (!setpoint_.is_waiting() || !outbox_.has_room<protocol::DriveSetpoint>(kSpareOfOthers)) {
    return;
  }
  if (const auto setpoint = setpoint_.take()) {
    outbox_.put(*setpoint, now_);
  }
}

void RobotLink::send_keep_alive() {
  // Where credit is so short that KeepAlives alone use it up, a command goes first in the end.
  const bool gives_way = command_waits_since_ && commands_.is_due(now_) &&
                         now_ - *command_waits_since_ > params_.credit.release_after;
  const bool is_due = keep_alive_ && now_ >= next_keep_alive_;
  if (!is_due || gives_way || !outbox_.has_room<protocol::KeepAlive>(0)) {
    return;
  }
  next_keep_alive_ = now_ + params_.keep_alive_period;
  const auto ttl = std::chrono::duration_cast<std::chrono::milliseconds>(params_.keep_alive_ttl);
  outbox_.put(protocol::KeepAlive{static_cast<std::uint16_t>(ttl.count())}, now_);
}

void RobotLink::send_ping() {
  if (!identification_.understands(protocol::Ping::kId) ||
      !identification_.understands(protocol::Pong::kId)) {
    return;
  }
  const bool frees_credit = outbox_.credit().wants_answer();
  if (!frees_credit && !pings_.is_due(now_)) {
    return;
  }
  const std::size_t lead_bytes = frees_credit ? 0 : pings_.lead_bytes();
  const std::size_t spare = frees_credit ? kSpareOfAnswered : kSpareOfOthers;
  if (outbox_.has_room<protocol::Ping>(spare + lead_bytes)) {
    outbox_.put_delimiters(lead_bytes, now_);
    outbox_.put(protocol::Ping{pings_.take(now_, clock_.uncertainty_us())}, now_);
  }
}

void RobotLink::send_command() {
  if (!commands_.is_due(now_)) {
    return;
  }
  const auto id =
      std::visit([](const auto& command) { return std::uint8_t{command.kId}; }, commands_.next());
  if (!identification_.understands(id)) {
    ++statistics_.frames_withheld;
    listener_.on_command_done(commands_.drop_next(CommandOutcome::kNotUnderstood));
    return;
  }
  if (!outbox_.has_room<Command>(kSpareOfAnswered)) {
    command_waits_since_ = command_waits_since_.value_or(now_);
    return;
  }
  command_waits_since_.reset();
  std::visit([this](const auto& message) { outbox_.put(message, now_); }, commands_.take(now_));
}

void RobotLink::send_bulk() {
  bulk_.give_up_if_exhausted(now_);
  end_reading();
  while (bulk_.is_due(now_) && outbox_.has_room<protocol::BulkRead>(kSpareOfOthers)) {
    outbox_.put(bulk_.take(now_), now_);
  }
}

void RobotLink::end_commands(CommandOutcome outcome) {
  for (const CommandResult& result : commands_.abandon(outcome)) {
    listener_.on_command_done(result);
  }
}

void RobotLink::send(const protocol::DriveSetpoint& setpoint, time::HostTime now) {
  now_ = now;
  if (state_ != LinkState::kReady) {
    return;
  }
  if (!identification_.understands(protocol::DriveSetpoint::kId)) {
    ++statistics_.frames_withheld;
    return;
  }
  setpoint_.put(setpoint, now);
  send_setpoint();
}

LinkStatistics RobotLink::statistics() const {
  LinkStatistics statistics = statistics_;
  telemetry_.add_to(statistics);
  outages_.add_to(statistics);
  inbox_.add_to(statistics);
  outbox_.add_to(statistics);
  statistics.setpoints_dropped = setpoint_.dropped();
  statistics.commands_resent = commands_.resent();
  statistics.round_trip = commands_.timer().smoothed_round_trip();
  return statistics;
}

}  // namespace echomap::robot_link
