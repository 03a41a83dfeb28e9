// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <string_view>

namespace echomap::mqtt {

/// How much is kept for a broker that is away.
struct OutboxParams {
  std::size_t max_messages = 10'000;  ///< Two hours of a robot's objects at one a second.
  std::size_t max_bytes = std::size_t{16} << 20;  ///< Topics and payloads.
};

/// A message to be delivered at least once.
struct OutgoingMessage {
  std::string topic;
  std::string payload;
  bool retain = false;
  int packet_id = 0;  ///< Of the packet it is on its way in.
};

/// What was handed over to be delivered at least once and is not acknowledged yet, in its order:
/// first what is on its way, then what waits. Of a retained topic only the newest waits. When it is
/// full, the oldest that waits makes room.
class Outbox {
 public:
  explicit Outbox(const OutboxParams& params) : params_(params) {}

  /// How many messages were dropped to make room; 1 where the message itself is.
  std::size_t push(const std::string& topic, std::string_view payload, bool retain);
  /// The first one that waits; null where none does.
  const OutgoingMessage* next() const;
  /// That one is on its way.
  void note_sent(int packet_id);
  /// Takes out the one that came in this packet; empty where none did.
  std::optional<OutgoingMessage> take_answered(int packet_id);
  /// Takes out the first one that waits.
  void drop_next();
  /// The connection has ended: nothing is on its way.
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
