// SPDX-License-Identifier: MIT
#include "tests/firmware/native_robot.hpp"

#include "protocol/version.hpp"

namespace echomap::tests {
namespace {

constexpr std::int64_t kMsNs = 1000000;

/// Keeps what the dispatcher decodes.
struct Keep {
  std::vector<Heard>& heard;
  std::int64_t now_ns;

  template <class M>
  void operator()(const M& message) {
    heard.push_back({now_ns, message});
  }
};

}  // namespace

NativeRobot::NativeRobot() : board(native::NativeBoard::instance()) {
  board.on_sent = [this](std::uint8_t byte) { listen(byte); };
  board.on_trigger = nullptr;
  board.set_bump(false, false);
  board.set_bump(true, false);
  power_on();
}

NativeRobot::~NativeRobot() {
  board.on_sent = nullptr;
  board.on_trigger = nullptr;
}

void NativeRobot::power_on() {
  heard.clear();
  bytes.clear();
  left_wheel = SimulatedWheel();
  right_wheel = SimulatedWheel();
  seq_ = 0;
  command_id_ = 0;
  board.power_on();
}

void NativeRobot::run_ms(int ms) {
  for (int i = 0; i < ms; ++i) {
    turn(false, left_wheel, board.left_duty());
    turn(true, right_wheel, board.right_duty());
    board.run_until_ns(board.now_ns() + kMsNs);
  }
}

std::optional<protocol::HelloReply> NativeRobot::connect(std::uint16_t session) {
  const std::int64_t from_ns = board.now_ns();
  send(protocol::Hello{
      protocol::kProtocolMajor, protocol::kProtocolMinor, protocol::kSchemaDigest, session});
  run_ms(20);
  for (const protocol::HelloReply& reply : all<protocol::HelloReply>(from_ns)) {
    if (reply.session == session) {
      return reply;
    }
  }
  return std::nullopt;
}

bool NativeRobot::arm() {
  return connect(1).has_value() &&
         command(protocol::Arm{0, 1}) == protocol::CommandStatus::kAccepted;
}

std::optional<protocol::CommandStatus> NativeRobot::ack_since(std::size_t first,
                                                              std::uint8_t id) const {
  for (std::size_t i = first; i < heard.size(); ++i) {
    const auto* ack = std::get_if<protocol::Ack>(&heard[i].message);
    if (ack != nullptr && ack->command_id == id) {
      return static_cast<protocol::CommandStatus>(ack->status);
    }
  }
  return std::nullopt;
}

void NativeRobot::turn(bool right, SimulatedWheel& wheel, int duty) {
  const std::int32_t from = wheel.ticks();
  wheel.step(0.001, duty);
  const std::int32_t to = wheel.ticks();
  const std::int32_t edges = std::abs(to - from);
  for (std::int32_t i = 1; i <= edges; ++i) {
    const std::uint8_t levels = quadrature_levels(to > from ? from + i : from - i);
    const std::int64_t at_ns = board.now_ns() + kMsNs * i / (edges + 1);
    board.schedule_encoder_edge(right, at_ns, (levels & 1U) != 0, (levels & 2U) != 0);
  }
}

void NativeRobot::listen(std::uint8_t byte) {
  bytes.push_back(byte);
  if (decoder_.take(byte) == protocol::DecodeStatus::kFrame) {
    const protocol::Frame frame = decoder_.frame();
    Keep keep{heard, board.now_ns()};
    protocol::Dispatcher<protocol::MessagesToHost>::dispatch(frame.id, frame.payload, keep);
  }
}

}  // namespace echomap::tests
