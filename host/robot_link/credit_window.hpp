// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>

#include "host/time/host_time.hpp"

namespace echomap::robot_link {

/// Names the answer that a frame waits for: the answer's message id and what is in it.
struct AnswerKey {
  std::uint8_t message_id = 0;
  std::uint32_t token = 0;
  bool operator==(const AnswerKey&) const = default;
};

/// How long unanswered bytes count as under way.
struct CreditParams {
  using Duration = time::HostClock::duration;
  /// The 133 ms that 128 bytes take at 9600 baud, and as much again for a robot that is busy. What
  /// is older has been taken or lost.
  Duration release_after = std::chrono::milliseconds(300);
};

/// Counts the bytes that were sent and may still wait in the robot's receive buffer, so that they
/// never become more than it holds. A robot takes frames in their order: an answer to one says that
/// all bytes up to that frame have left the buffer.
class CreditWindow {
 public:
  /// Throws std::invalid_argument unless `release_after` is positive.
  explicit CreditWindow(const CreditParams& params = {});

  /// What the robot's buffer holds; before the first grant nothing is held back.
  void grant(std::size_t bytes) { limit_bytes_ = bytes; }

  /// Whether `bytes` more may be sent and leave `spare` for others. A frame that is alone under way
  /// always may, so that a robot which grants less than a frame can be spoken to.
  bool has_room(std::size_t bytes, std::size_t spare) const;
  /// Frames without an answer have used up a quarter of the credit: only an answer frees it soon.
  bool wants_answer() const;

  /// `bytes` were sent; without a `key` nothing answers them.
  void add(std::size_t bytes, const std::optional<AnswerKey>& key, time::HostTime now);
  /// The answer came. Where several frames wait for the same one, it answers the oldest.
  void confirm(const AnswerKey& key);
  /// Forgets what was sent `release_after` ago.
  void release_overdue(time::HostTime now);

  std::size_t unconfirmed_bytes() const { return unconfirmed_bytes_; }
  /// Bytes that no answer confirmed in time.
  std::uint64_t released_bytes() const { return released_bytes_; }

 private:
  struct Sent {
    std::size_t bytes;
    std::optional<AnswerKey> key;
    time::HostTime at;
  };

  void pop_front();

  CreditParams params_;
  std::optional<std::size_t> limit_bytes_;
  std::deque<Sent> under_way_;
  std::size_t unconfirmed_bytes_ = 0;
  std::size_t unanswerable_bytes_ = 0;  ///< Behind the last frame that has an answer.
  std::uint64_t released_bytes_ = 0;
};

}  // namespace echomap::robot_link
