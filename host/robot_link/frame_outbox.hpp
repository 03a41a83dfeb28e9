// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "host/robot_link/command.hpp"
#include "host/robot_link/credit_window.hpp"
#include "host/robot_link/link_statistics.hpp"
#include "protocol/bulk_messages.hpp"
#include "protocol/frame_encoder.hpp"
#include "protocol/handshake_messages.hpp"
#include "protocol/message_codec.hpp"

namespace echomap::robot_link {

/// Bytes that M takes on the wire; of a variant, its largest message.
template <class M>
constexpr std::size_t kFrameBytes = protocol::MessageFacts<M>::kSize + protocol::kFrameOverhead;
template <class... Ms>
constexpr std::size_t kFrameBytes<std::variant<Ms...>> = std::max({kFrameBytes<Ms>...});

/// What a frame must leave of the credit, so that none starves: what may wait gives way to commands
/// and to pings that ask for credit, and those to what keeps a robot moving.
constexpr std::size_t kSpareOfAnswered = kFrameBytes<protocol::KeepAlive>;
constexpr std::size_t kSpareOfOthers = kSpareOfAnswered + kFrameBytes<Command>;

/// What the host sends: numbers frames, and counts them against the robot's credit until they are
/// answered.
class FrameOutbox {
 public:
  explicit FrameOutbox(const CreditParams& credit) : credit_(credit) {}

  /// Whether a frame of M, which may be Command, may go now and leave `spare`.
  template <class M>
  bool has_room(std::size_t spare) {
    const bool has_room = credit_.has_room(kFrameBytes<M>, spare);
    waits_ += has_room ? 0 : 1;
    return has_room;
  }

  /// Puts a frame into the outgoing bytes.
  template <class M>
  void put(const M& message, time::HostTime now) {
    const protocol::ByteSpan frame = encoder_.encode(message, next_seq_++);
    outgoing_.insert(outgoing_.end(), frame.data, frame.data + frame.size);
    ++frames_sent_;
    credit_.add(frame.size, answer_to(message), now);
  }
  /// The first ends whatever the robot's decoder holds of earlier bytes, more only take time.
  void put_delimiters(std::size_t count, time::HostTime now) {
    outgoing_.insert(outgoing_.end(), count, 0);
    credit_.add(count, std::nullopt, now);
  }

  /// Takes the robot's answers.
  void confirm(const protocol::HelloReply& reply);
  void confirm(const protocol::Ack& ack) { credit_.confirm({ack.kId, ack.command_id}); }
  void confirm(const protocol::BulkData& data) {
    credit_.confirm({data.kId, piece_key(data.content, data.offset)});
  }
  void confirm(const protocol::Pong& pong) { credit_.confirm({pong.kId, pong.token}); }

  /// The bytes since the last call.
  std::vector<std::uint8_t> take_outgoing() { return std::exchange(outgoing_, {}); }

  CreditWindow& credit() { return credit_; }
  const CreditWindow& credit() const { return credit_; }
  /// Fills in what was sent, and what for want of credit was not.
  void add_to(LinkStatistics& statistics) const;

 private:
  static std::optional<AnswerKey> answer_to(const protocol::Hello& /*hello*/) {
    return AnswerKey{protocol::HelloReply::kId, 0};
  }
  static std::optional<AnswerKey> answer_to(const protocol::Ping& ping) {
    return AnswerKey{protocol::Pong::kId, ping.token};
  }
  static std::optional<AnswerKey> answer_to(const protocol::BulkRead& read) {
    return AnswerKey{protocol::BulkData::kId, piece_key(read.content, read.offset)};
  }
  static std::uint32_t piece_key(std::uint8_t content, std::uint16_t offset) {
    return static_cast<std::uint32_t>(content) << 16U | offset;
  }
  template <class M>
  static std::optional<AnswerKey> answer_to(const M& message) {
    if constexpr (M::message_class() == protocol::MessageClass::kCommand) {
      return AnswerKey{protocol::Ack::kId, message.command_id};
    } else {
      return std::nullopt;
    }
  }

  protocol::FrameEncoder encoder_;
  CreditWindow credit_;
  std::vector<std::uint8_t> outgoing_;
  std::uint8_t next_seq_ = 0;
  std::uint64_t frames_sent_ = 0;
  std::uint64_t waits_ = 0;  ///< How often a frame had to wait, looked at every `poll`.
};

}  // namespace echomap::robot_link
