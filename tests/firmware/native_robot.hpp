// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

#include "firmware/boards/native/native_board.hpp"
#include "protocol/frame_decoder.hpp"
#include "protocol/frame_encoder.hpp"
#include "protocol/messages.hpp"
#include "tests/firmware/simulated_wheel.hpp"
#include "tests/support/message_variant.hpp"

namespace echomap::tests {

/// A message of the robot and when its last stop bit was over.
struct Heard {
  std::int64_t at_ns;
  MessageToHost message;
};

/// The native board with two wheels and a host that speaks the protocol byte by byte.
class NativeRobot {
 public:
  NativeRobot();
  ~NativeRobot();
  NativeRobot(const NativeRobot&) = delete;
  NativeRobot& operator=(const NativeRobot&) = delete;

  native::NativeBoard& board;
  SimulatedWheel left_wheel;
  SimulatedWheel right_wheel;
  /// Every message so far, and every raw byte.
  std::vector<Heard> heard;
  std::vector<std::uint8_t> bytes;

  /// Switches on again: time 0, nothing heard.
  void power_on();
  void run_ms(int ms);

  template <class M>
  void send(const M& message) {
    const protocol::ByteSpan frame = encoder_.encode(message, seq_++);
    board.receive(frame.data, frame.size);
  }

  /// Hello, and the reply to it.
  std::optional<protocol::HelloReply> connect(std::uint16_t session);

  /// Sends a command with a new id; the status of its Ack, or empty where none came in 50 ms.
  template <class M>
  std::optional<protocol::CommandStatus> command(M message) {
    message.command_id = ++command_id_;
    const std::size_t before = heard.size();
    send(message);
    run_ms(50);
    return ack_since(before, command_id_);
  }

  /// Connects and arms.
  bool arm();
  std::uint8_t last_command_id() const { return command_id_; }

  /// The messages of one kind that were heard at or after `from_ns`.
  template <class M>
  std::vector<M> all(std::int64_t from_ns = 0) const {
    std::vector<M> found;
    for (const Heard& one : heard) {
      if (one.at_ns >= from_ns && std::holds_alternative<M>(one.message)) {
        found.push_back(std::get<M>(one.message));
      }
    }
    return found;
  }

 private:
  std::optional<protocol::CommandStatus> ack_since(std::size_t first, std::uint8_t id) const;
  void turn(bool right, SimulatedWheel& wheel, int duty);
  void listen(std::uint8_t byte);

  protocol::FrameEncoder encoder_;
  protocol::FrameDecoder decoder_{protocol::MessagesToHost::find_schema};
  std::uint8_t seq_ = 0;
  std::uint8_t command_id_ = 0;
};

}  // namespace echomap::tests
