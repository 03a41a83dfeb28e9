// SPDX-License-Identifier: MIT
#include "host/robot_link/robot_link.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "protocol/limits.hpp"
#include "protocol/version.hpp"

namespace echomap::robot_link {

using protocol::MessagesToHost;

namespace {

RobotLinkParams checked(const RobotLinkParams& params) {
  using Duration = RobotLinkParams::Duration;
  const bool holds =
      params.hello_period > Duration::zero() && params.keep_alive_period > Duration::zero() &&
      params.keep_alive_ttl > params.keep_alive_period &&
      params.keep_alive_ttl <= std::chrono::milliseconds(500) &&
      params.lost_after > params.quiet_after && params.diagnose_after > params.hello_period;
  if (!holds) {
    throw std::invalid_argument("robot link: periods do not fit together");
  }
  return params;
}

/// As the robot reads it: 0 stands for the default.
std::chrono::milliseconds time_to_live(const protocol::DriveSetpoint& setpoint) {
  return std::chrono::milliseconds(setpoint.time_to_live_ms == 0 ? protocol::kDefaultTimeToLiveMs
                                                                 : setpoint.time_to_live_ms);
}

}  // namespace

RobotLinkParams radio_link() {
  RobotLinkParams params;
  params.retransmission = radio_retransmission();
  params.keep_alive_ttl = std::chrono::milliseconds(500);
  return params;
}

RobotLink::RobotLink(RobotLinkListener& listener,
                     std::uint16_t session,
                     const RobotLinkParams& params)
    : listener_(listener),
      session_(session),
      params_(checked(params)),
      outbox_(params.credit),
      commands_(params.retransmission, params.command_tries),
      bulk_(params.retransmission, params.bulk),
      pings_(params.ping),
      clock_(params.clock) {
  if (session == 0) {
    throw std::invalid_argument("robot link: session 0 stands for none");
  }
}

void RobotLink::receive(std::span<const std::uint8_t> bytes, time::HostTime now) {
  now_ = now;
  if (!bytes.empty()) {
    last_byte_at_ = now;
  }
  statistics_.bytes_received += bytes.size();
  for (const std::uint8_t byte : bytes) {
    take_byte(byte);
  }
}

void RobotLink::take_byte(std::uint8_t byte) {
  const InboxEvent event = inbox_.take(byte, difference_);
  if (event == InboxEvent::kForeign) {
    last_frame_at_ = now_;
  }
  if (event != InboxEvent::kFrame) {
    return;
  }
  const protocol::Frame frame = inbox_.frame();
  // A robot that was reset unheard answers pings too, and only Hello finds that out.
  if (frame.id != protocol::Pong::kId) {
    last_frame_at_ = now_;
  }
  auto handler = [this](const auto& message) { handle(message); };
  protocol::Dispatcher<MessagesToHost>::dispatch(frame.id, frame.payload, handler);
  inbox_.count_frame();
}

void RobotLink::handle(const protocol::HelloReply& reply) {
  if (robot_ && robot_->boot_id != reply.boot_id) {
    notice_reset(reply);
  }
  if (reply.session != session_) {
    return;
  }
  outbox_.confirm(reply);
  robot_ = reply;
  if (state_ != LinkState::kReady && state_ != LinkState::kDescribing) {
    describe_or_be_ready(reply);
  }
}

void RobotLink::describe_or_be_ready(const protocol::HelloReply& robot) {
  if (robot.protocol_major != protocol::kProtocolMajor) {
    refuse(robot, "");
  } else if (speaks_our_protocol(robot)) {
    difference_.reset();
    be_ready(robot);
  } else if (difference_ && described_digest_ == robot.schema_digest) {
    be_ready(robot);
  } else {
    state_ = LinkState::kDescribing;
    bulk_.start(protocol::BulkContent::kSchema);
  }
}

void RobotLink::be_ready(const protocol::HelloReply& robot) {
  state_ = LinkState::kReady;
  newest_stamp_us_.reset();
  pings_.restart(now_);
  listener_.on_ready(robot);
}

void RobotLink::refuse(const protocol::HelloReply& robot, const std::string& difference) {
  ProtocolMismatch mismatch = mismatch_with(robot);
  mismatch.difference = difference;
  mismatch_ = mismatch;
  state_ = LinkState::kMismatch;
}

void RobotLink::take_description(const BulkResult& result) {
  const bool is_lost =
      result.status == BulkStatus::kNoAnswer && !is_within(params_.lost_after, last_frame_at_);
  if (!robot_ || is_lost) {
    state_ = LinkState::kLost;
    return;
  }
  const protocol::HelloReply& robot = *robot_;
  const auto schema =
      result.status == BulkStatus::kWhole ? read_robot_schema(result.bytes) : std::nullopt;
  if (!schema || digest_of(*schema) != robot.schema_digest) {
    refuse(robot, "");
    return;
  }
  const SchemaDifference& difference = difference_.emplace(*schema);
  described_digest_ = robot.schema_digest;
  if (std::ranges::all_of(params_.needed_messages,
                          [&](auto id) { return difference.agrees(id); })) {
    be_ready(robot);
  } else {
    refuse(robot, difference.summary());
  }
}

bool RobotLink::understands(std::uint8_t message_id) const {
  return !difference_ || difference_->agrees(message_id);
}

void RobotLink::notice_reset(const protocol::HelloReply& reply) {
  robot_ = reply;
  state_ = LinkState::kConnecting;
  connecting_since_ = now_;
  inbox_.restart();
  ++statistics_.resets_seen;
  clock_.restart();
  bulk_.abandon();
  end_reading();
  end_commands(CommandOutcome::kRobotReset);
  listener_.on_reset(reply.reset_cause);
}

void RobotLink::handle(const protocol::Ack& ack) {
  outbox_.confirm(ack);
  if (const auto result = commands_.acknowledge(ack, now_)) {
    listener_.on_command_done(*result);
  }
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

void RobotLink::handle(const protocol::Odometry& message) {
  if (accepts_telemetry(message.stamp_us)) {
    listener_.on_odometry(message);
  }
}

void RobotLink::handle(const protocol::Echo& message) {
  if (accepts_telemetry(message.stamp_us)) {
    listener_.on_echo(message);
  }
}

void RobotLink::handle(const protocol::Status& message) {
  if (accepts_telemetry(message.stamp_us)) {
    listener_.on_status(message);
  }
}

void RobotLink::handle(const protocol::Health& message) {
  if (!accepts_telemetry(message.stamp_us)) {
    return;
  }
  statistics_.robot_frames_bad = message.frames_bad;
  statistics_.robot_frames_lost = message.frames_lost;
  statistics_.robot_receive_overruns = message.receive_overruns;
  statistics_.robot_telemetry_dropped = message.telemetry_dropped;
  listener_.on_health(message);
}

void RobotLink::handle(const protocol::Ranges& message) {
  if (accepts_telemetry(message.stamp_us)) {
    listener_.on_ranges(message);
  }
}

void RobotLink::handle(const protocol::Gyro& message) {
  if (accepts_telemetry(message.stamp_us)) {
    listener_.on_gyro(message);
  }
}

bool RobotLink::accepts_telemetry(std::uint32_t stamp_us) {
  if (state_ != LinkState::kReady) {
    return false;
  }
  const std::chrono::microseconds step(
      newest_stamp_us_ ? static_cast<std::int32_t>(stamp_us - *newest_stamp_us_) : 0);
  if (step < -params_.max_step_back) {
    state_ = LinkState::kConnecting;
    connecting_since_ = now_;
    return false;
  }
  if (!newest_stamp_us_ || step.count() > 0) {
    newest_stamp_us_ = stamp_us;
  }
  clock_.add_telemetry(stamp_us, now_);
  return true;
}

void RobotLink::poll(time::HostTime now) {
  now_ = now;
  outbox_.credit().release_overdue(now);
  update_state();
  if (is_hello_due()) {
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

void RobotLink::update_state() {
  switch (state_) {
    case LinkState::kReady:
      if (!is_within(params_.lost_after, last_frame_at_) || commands_.is_exhausted(now_)) {
        state_ = LinkState::kLost;
      }
      break;
    case LinkState::kConnecting:
    case LinkState::kSilent:
    case LinkState::kGarbage:
    case LinkState::kUnheard:
      state_ = diagnose();
      break;
    case LinkState::kDescribing:
    case LinkState::kMismatch:
    case LinkState::kLost:
      break;
  }
}

LinkState RobotLink::diagnose() {
  if (!connecting_since_) {
    connecting_since_ = now_;
  }
  if (now_ - *connecting_since_ < params_.diagnose_after) {
    return LinkState::kConnecting;
  }
  if (is_within(params_.diagnose_after, last_frame_at_)) {
    return LinkState::kUnheard;
  }
  return is_within(params_.diagnose_after, last_byte_at_) ? LinkState::kGarbage
                                                          : LinkState::kSilent;
}

bool RobotLink::is_within(Duration duration, const std::optional<time::HostTime>& instant) const {
  return instant && now_ - *instant <= duration;
}

bool RobotLink::is_hello_due() const {
  const bool is_settled = state_ == LinkState::kMismatch || state_ == LinkState::kDescribing;
  if (is_settled || now_ < next_hello_) {
    return false;
  }
  return state_ != LinkState::kReady || !is_within(params_.quiet_after, last_frame_at_);
}

void RobotLink::send_hello() {
  next_hello_ = now_ + params_.hello_period;
  // Ends whatever a reset or an earlier host left unfinished in the robot's decoder.
  outbox_.put_delimiter(now_);
  outbox_.put(
      protocol::Hello{
          protocol::kProtocolMajor, protocol::kProtocolMinor, protocol::kSchemaDigest, session_},
      now_);
}

void RobotLink::send_setpoint() {
  if (!setpoint_) {
    return;
  }
  if (now_ - setpoint_->since > time_to_live(setpoint_->message)) {
    ++statistics_.setpoints_dropped;
    setpoint_.reset();
  } else if (outbox_.has_room<protocol::DriveSetpoint>(kSpareOfOthers)) {
    outbox_.put(setpoint_->message, now_);
    setpoint_.reset();
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
  if (!understands(protocol::Ping::kId) || !understands(protocol::Pong::kId)) {
    return;
  }
  const bool frees_credit = outbox_.credit().wants_answer();
  const bool is_due = frees_credit || pings_.is_due(now_);
  if (is_due &&
      outbox_.has_room<protocol::Ping>(frees_credit ? kSpareOfAnswered : kSpareOfOthers)) {
    outbox_.put(protocol::Ping{pings_.take(now_, clock_.uncertainty_us())}, now_);
  }
}

void RobotLink::send_command() {
  if (!commands_.is_due(now_)) {
    return;
  }
  const auto id =
      std::visit([](const auto& command) { return std::uint8_t{command.kId}; }, commands_.next());
  if (!understands(id)) {
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
  if (!understands(protocol::DriveSetpoint::kId)) {
    ++statistics_.frames_withheld;
    return;
  }
  statistics_.setpoints_dropped += setpoint_ ? 1 : 0;
  setpoint_ = {setpoint, now};
  send_setpoint();
}

LinkStatistics RobotLink::statistics() const {
  LinkStatistics statistics = statistics_;
  statistics.frames_received = inbox_.frames_received();
  statistics.frames_bad = inbox_.frames_bad();
  statistics.frames_lost = inbox_.frames_lost();
  statistics.frames_foreign = inbox_.frames_foreign();
  statistics.frames_sent = outbox_.frames_sent();
  statistics.commands_resent = commands_.resent();
  statistics.credit_waits = outbox_.waits();
  statistics.credit_released_bytes = outbox_.credit().released_bytes();
  statistics.round_trip = commands_.timer().smoothed_round_trip();
  return statistics;
}

}  // namespace echomap::robot_link
