// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "protocol/frame_decoder.hpp"
#include "protocol/frame_encoder.hpp"
#include "protocol/link.hpp"
#include "protocol/messages.hpp"
#include "tests/hil/emulated_board.hpp"
#include "tests/support/message_variant.hpp"

namespace echomap::tests {

/// A message of the robot and when its last stop bit was over.
struct Heard {
  std::int64_t at_ns;
  MessageToHost message;
};

/// A robot without a body: the release firmware on an emulated board, with a host that speaks the
/// protocol byte by byte in simulated time.
class RobotSession {
 public:
  explicit RobotSession(const std::filesystem::path& elf);

  runner::SimulatedBoard& board() { return board_; }
  EmulatedBoard& chip() { return *chip_; }

  /// Runs, calling `each_ms` before every millisecond.
  void run_ms(std::int64_t ms);
  /// Runs until `done()`, asked every 20 us; false where that is not within `ms`.
  bool run_until(const std::function<bool()>& done, std::int64_t ms);
  std::function<void()> each_ms;

  template <class M>
  void send(const M& message) {
    const protocol::ByteSpan frame = encoder_.encode(message, next_seq_++);
    board_.receive({frame.data, frame.size});
  }

  /// Lets the robot boot, then says Hello until it answers.
  std::optional<protocol::HelloReply> connect(std::uint16_t session = 4711);

  /// Sends a command with the next id; the robot's answer, or empty where none came in 100 ms.
  template <class M>
  std::optional<protocol::CommandStatus> command(M message) {
    last_command_id_ = protocol::next_command_id(last_command_id_);
    message.command_id = last_command_id_;
    send(message);
    return await_ack();
  }
  std::uint8_t last_command_id() const { return last_command_id_; }

  const std::vector<Heard>& heard() const { return heard_; }
  void forget_heard() { heard_.clear(); }
  /// Every byte sent and when its stop bit was over, for comparisons.
  const std::vector<std::pair<std::int64_t, std::uint8_t>>& bytes() const { return bytes_; }
  /// What this host could not read.
  const protocol::ReceiveCounters& counters() const { return counters_; }

  /// The newest message M since `forget_heard`.
  template <class M>
  std::optional<M> last() const {
    for (auto it = heard_.rbegin(); it != heard_.rend(); ++it) {
      if (const M* message = std::get_if<M>(&it->message)) {
        return *message;
      }
    }
    return std::nullopt;
  }

  template <class M>
  std::vector<M> all() const {
    std::vector<M> messages;
    for (const Heard& heard : heard_) {
      if (const M* message = std::get_if<M>(&heard.message)) {
        messages.push_back(*message);
      }
    }
    return messages;
  }

  template <class M>
  void operator()(const M& message) {
    heard_.push_back({board_.now_ns(), message});
  }

 private:
  void take(std::uint8_t byte);
  std::optional<protocol::CommandStatus> await_ack();

  std::unique_ptr<EmulatedBoard> chip_;
  runner::SimulatedBoard& board_;
  protocol::FrameEncoder encoder_;
  protocol::FrameDecoder decoder_{protocol::MessagesToHost::find_schema};
  protocol::ReceiveCounters counters_;
  std::uint8_t next_seq_ = 0;
  std::uint8_t last_command_id_ = 0;
  std::vector<Heard> heard_;
  std::vector<std::pair<std::int64_t, std::uint8_t>> bytes_;
};

}  // namespace echomap::tests
