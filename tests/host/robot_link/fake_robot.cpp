// SPDX-License-Identifier: MIT
#include "tests/host/robot_link/fake_robot.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <iterator>
#include <type_traits>
#include <utility>

#include "protocol/schema_description.hpp"
#include "protocol/version.hpp"

namespace echomap::robot_link {

void FakeRobot::power_on(std::uint16_t boot_id, std::uint8_t reset_cause) {
  boot_id_ = boot_id;
  reset_cause_ = reset_cause;
  decoder_ = protocol::FrameDecoder(protocol::MessagesToRobot::find_schema);
  counters_ = {};
  filter_ = {};
  outgoing_.clear();
  next_seq_ = 0;
  stamp_us_ = 0;
  greeted_ = false;
  armed = false;
  status_ = {};
  configuration = {};
  motion_left_ms_ = 0;
  if (announces_boot) {
    reply(0);
  }
}

void FakeRobot::receive(std::span<const std::uint8_t> bytes) {
  for (const std::uint8_t byte : bytes) {
    const protocol::DecodeStatus status = decoder_.take(byte);
    const bool is_frame = status == protocol::DecodeStatus::kFrame;
    const std::uint8_t seq = is_frame ? decoder_.frame().seq : std::uint8_t{0};
    if (is_frame) {
      take(decoder_.frame());
    }
    if (is_frame && decoder_.frame().id != protocol::Hello::kId) {
      filter_.hear();
    }
    // As the firmware does it: a Hello of a new session begins the counting anew.
    counters_.take(status, seq);
  }
}

void FakeRobot::take(const protocol::Frame& frame) {
  auto handler = [this](const auto& message) { handle(message); };
  protocol::Dispatcher<protocol::MessagesToRobot>::dispatch(frame.id, frame.payload, handler);
}

void FakeRobot::handle(const protocol::Hello& hello) {
  ++hellos;
  if (protocol_minor >= 3 && filter_.refuses(hello.session)) {
    reply(filter_.session());
    return;
  }
  begin_session(hello.session);
}

void FakeRobot::begin_session(std::uint16_t session) {
  if (filter_.begin_session(session)) {
    counters_.restart();
    armed = false;
  }
  greeted_ = true;
  reply(session);
}

FakeRobot::Bytes FakeRobot::configuration_bytes() const {
  const protocol::ConfigurationBytes all = protocol::configuration_bytes(configuration);
  Bytes held(std::begin(all.bytes), std::end(all.bytes));
  if (!holds_wiring || !holds_scalar) {
    held.resize(held.size() - protocol::payload_size_of<protocol::ConfigureScalar>());
  }
  if (!holds_wiring) {
    held.resize(held.size() - protocol::payload_size_of<protocol::ConfigureWiring>());
  }
  return held;
}

void FakeRobot::reply(std::uint16_t session) {
  protocol::SchemaHash config_digest;
  for (const std::uint8_t byte : configuration_bytes()) {
    config_digest.add(static_cast<char>(byte));
  }
  outgoing_.push_back(0);
  send(protocol::HelloReply{protocol_major,
                            protocol_minor,
                            schema_digest,
                            protocol::kFirmwareVersion,
                            boot_id_,
                            reset_cause_,
                            session,
                            1000,
                            receive_credit_bytes,
                            capabilities,
                            config_digest.value()});
}

void FakeRobot::handle(const protocol::Ping& ping) {
  ++pings;
  if (answers_pings) {
    send(protocol::Pong{ping.token, stamp_us_});
  }
}

template <class Command>
void FakeRobot::handle(const Command& command) {
  const bool knows_scalar = holds_wiring && holds_scalar;
  if ((std::is_same_v<Command, protocol::ConfigureWiring> && !holds_wiring) ||
      (std::is_same_v<Command, protocol::ConfigureScalar> && !knows_scalar)) {
    return;
  }
  command_ids_received.push_back(command.command_id);
  if (!filter_.is_repeat(command.command_id)) {
    if (on_command) {
      on_command(Command::name());
    }
    filter_.remember(command.command_id, carry_out(command));
  }
  if (acknowledges) {
    send(filter_.answer());
  }
}

protocol::CommandStatus FakeRobot::carry_out(const protocol::MoveTicks& move) {
  if (!greeted_ || (needs_arming && !armed)) {
    return protocol::CommandStatus::kDisarmed;
  }
  moves_done.push_back(move.left_ticks);
  status_.move_id = move.command_id;
  status_.move_outcome = static_cast<std::uint8_t>(protocol::MotionOutcome::kRunning);
  motion_left_ms_ = motion_ms;
  return answer;
}

protocol::CommandStatus FakeRobot::carry_out(const protocol::StartSweep& sweep) {
  if (status_.sweep_outcome == static_cast<std::uint8_t>(protocol::MotionOutcome::kRunning)) {
    return protocol::CommandStatus::kBusy;
  }
  ++sweeps;
  status_.sweep_id = sweep.command_id;
  status_.sweep_outcome = static_cast<std::uint8_t>(protocol::MotionOutcome::kRunning);
  motion_left_ms_ = motion_ms;
  return answer;
}

protocol::CommandStatus FakeRobot::carry_out(const protocol::Stop& /*stop*/) {
  end_motions(protocol::MotionOutcome::kStopped);
  return answer;
}

protocol::CommandStatus FakeRobot::carry_out(const protocol::Arm& arm) {
  armed = arm.armed != 0;
  filter_.hold(armed);
  return answer;
}

template <class Settings>
protocol::CommandStatus FakeRobot::take_settings(Settings& held, const Settings& settings) {
  ++configurations;
  if (answer == protocol::CommandStatus::kAccepted) {
    held = settings;
    configuration.pan.max_cdeg +=
        std::is_same_v<Settings, protocol::ConfigurePan> ? pan_error_cdeg : 0;
  }
  return answer;
}

FakeRobot::Bytes FakeRobot::described_messages() {
  constexpr auto kDescription = protocol::describe_schema<protocol::AllMessages>();
  return {std::begin(kDescription.bytes), std::end(kDescription.bytes)};
}

FakeRobot::Bytes FakeRobot::bulk_content(std::uint8_t content) const {
  switch (static_cast<protocol::BulkContent>(content)) {
    case protocol::BulkContent::kSchema:
      return schema;
    case protocol::BulkContent::kConfiguration:
      return configuration_bytes();
  }
  return {};
}

void FakeRobot::handle(const protocol::BulkRead& read) {
  ++bulk_reads;
  if (!answers_bulk_reads) {
    return;
  }
  const Bytes content = bulk_content(read.content);
  std::array<std::uint32_t, 8> words{};
  if (read.offset < content.size()) {
    std::memcpy(words.data(),
                content.data() + read.offset,
                std::min(sizeof(words), content.size() - read.offset));
  }
  send(protocol::BulkData{read.content,
                          read.offset,
                          static_cast<std::uint16_t>(content.size()),
                          words[0],
                          words[1],
                          words[2],
                          words[3],
                          words[4],
                          words[5],
                          words[6],
                          words[7]});
}

void FakeRobot::end_motions(protocol::MotionOutcome end) {
  const auto running = static_cast<std::uint8_t>(protocol::MotionOutcome::kRunning);
  for (std::uint8_t* one : {&status_.move_outcome, &status_.sweep_outcome}) {
    *one = *one == running ? static_cast<std::uint8_t>(end) : *one;
  }
}

void FakeRobot::advance_1ms() {
  stamp_us_ += 1000;
  filter_.pass(1);
  if (!greeted_ && !streams_before_hello) {
    return;
  }
  if (stamp_us_ % 20'000 == 0) {
    send(protocol::Odometry{stamp_us_, 0, 0, 0});
  }
  if (motion_left_ms_ > 0 && --motion_left_ms_ == 0) {
    end_motions(outcome);
  }
  if (stamp_us_ % 200'000 == 0) {
    status_.stamp_us = stamp_us_;
    status_.hazards = hazards;
    send(status_);
    protocol::Health health{};
    health.stamp_us = stamp_us_;
    health.frames_bad = counters_.frames_bad();
    health.frames_lost = counters_.frames_lost();
    send(health);
  }
}

FakeRobot::Bytes FakeRobot::take_outgoing() { return std::exchange(outgoing_, {}); }

}  // namespace echomap::robot_link
