// SPDX-License-Identifier: MIT
#include "tests/hil/robot_session.hpp"

#include "protocol/message_codec.hpp"
#include "protocol/version.hpp"
#include "tests/support/simulated_time.hpp"

namespace echomap::tests {
namespace {

constexpr std::int64_t kPollNs = 20'000;
constexpr std::int64_t kHelloPeriodMs = 50;
constexpr std::int64_t kBootMs = 20;
constexpr int kHellos = 10;
constexpr std::int64_t kAckTimeoutMs = 100;

}  // namespace

RobotSession::RobotSession(const std::filesystem::path& elf)
    : chip_(make_emulated_board(elf)), board_(chip_->pins()) {
  board_.on_sent = [this](std::uint8_t byte) { take(byte); };
}

void RobotSession::run_ms(std::int64_t ms) {
  for (std::int64_t i = 0; i < ms; ++i) {
    if (each_ms) {
      each_ms();
    }
    board_.run_until(board_.now_ns() + kMs);
  }
}

bool RobotSession::run_until(const std::function<bool()>& done, std::int64_t ms) {
  for (std::int64_t step = 0; step < ms * kMs / kPollNs; ++step) {
    if (done()) {
      return true;
    }
    if (each_ms && step % (kMs / kPollNs) == 0) {
      each_ms();
    }
    board_.run_until(board_.now_ns() + kPollNs);
  }
  return done();
}

std::optional<protocol::HelloReply> RobotSession::connect(std::uint16_t session) {
  const auto answered = [&] {
    const auto reply = last<protocol::HelloReply>();
    return reply && reply->session == session;
  };
  run_ms(kBootMs);
  constexpr std::uint8_t kDelimiter = 0;
  for (int i = 0; i < kHellos && !answered(); ++i) {
    board_.receive({&kDelimiter, 1});
    send(protocol::Hello{
        protocol::kProtocolMajor, protocol::kProtocolMinor, protocol::kSchemaDigest, session});
    run_until(answered, kHelloPeriodMs);
  }
  last_command_id_ = 0;
  return answered() ? last<protocol::HelloReply>() : std::nullopt;
}

void RobotSession::take(std::uint8_t byte) {
  bytes_.emplace_back(board_.now_ns(), byte);
  const protocol::DecodeStatus status = decoder_.take(byte);
  if (status == protocol::DecodeStatus::kIncomplete) {
    return;
  }
  const protocol::Frame frame = decoder_.frame();
  counters_.take(status, frame.seq);
  if (status == protocol::DecodeStatus::kFrame) {
    protocol::Dispatcher<protocol::MessagesToHost>::dispatch(frame.id, frame.payload, *this);
  }
}

std::optional<protocol::CommandStatus> RobotSession::await_ack() {
  const auto answer = [this]() -> std::optional<protocol::CommandStatus> {
    for (const auto& ack : all<protocol::Ack>()) {
      if (ack.command_id == last_command_id_) {
        return static_cast<protocol::CommandStatus>(ack.status);
      }
    }
    return std::nullopt;
  };
  heard_.clear();
  run_until([&] { return answer().has_value(); }, kAckTimeoutMs);
  return answer();
}

}  // namespace echomap::tests
