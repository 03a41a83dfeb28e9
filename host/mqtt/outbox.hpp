// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <string_view>

namespace echomap::mqtt {

/// How much is stored while the broker is away.
struct OutboxParams {
  std::size_t max_messages = 10'000;  ///< Two hours of a robot's objects at one a second.
  std::size_t max_bytes = std::size_t{16} << 20;  ///< Topics and payloads.
};

/// A message to be delivered at least once.
struct OutgoingMessage {
  std::string topic;
  std::string payload;
  bool retain = false;
  int packet_id = 0;  ///< Packet in which it is in flight.
};

/// Messages to be delivered at least once that are not acknowledged yet, in their order: first
/// those in flight, then those that wait. Of a retained topic only the newest waits. When it is
/// full, the oldest that waits is dropped.
class Outbox {
 public:
  explicit Outbox(const OutboxParams& params) : params_(params) {}

  /// Adds a message. Returns how many were dropped to make room; 1 where it is the message itself.
  std::size_t push(const std::string& topic, std::string_view payload, bool retain);
  /// The first message that waits; null where none does.
  const OutgoingMessage* next() const;
  /// Marks that message as in flight, in this packet.
  void note_sent(int packet_id);
  /// Removes and returns the message of this packet; empty where there is none.
  std::optional<OutgoingMessage> take_answered(int packet_id);
  /// Removes the first message that waits.
  void drop_next();
  /// The connection has ended: no message is in flight.
  void reset_sent() { sent_ = 0; }

  std::size_t sent() const { return sent_; }
  std::size_t size() const { return messages_.size(); }
  bool empty() const { return messages_.empty(); }

 private:
  using Iterator = std::deque<OutgoingMessage>::iterator;

  Iterator first_waiting() { return messages_.begin() + static_cast<std::ptrdiff_t>(sent_); }
  OutgoingMessage take(const Iterator& message);

  OutboxParams params_;
  std::deque<OutgoingMessage> messages_;
  std::size_t sent_ = 0;
  std::size_t bytes_ = 0;
};

}  // namespace echomap::mqtt
