// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <deque>
#include <span>

namespace echomap::runner {

/// What happens to bytes that nobody reads.
enum class WhenUnread : std::uint8_t {
  /// Kept: a host in lockstep reads every byte.
  kKeep,
  /// Beyond a few thousand they are lost, as on a wire.
  kDrop,
};

/// Bytes on their way into a descriptor that may be full.
class OutgoingBytes {
 public:
  explicit OutgoingBytes(WhenUnread when_unread) : when_unread_(when_unread) {}

  void push(std::span<const std::uint8_t> bytes);
  /// Writes what the non-blocking `descriptor` takes now; whether the other end is still there.
  bool write_to(int descriptor);
  /// Forgets everything and counts it as dropped.
  void discard();

  bool empty() const { return bytes_.empty(); }
  std::uint64_t dropped() const { return dropped_; }

 private:
  WhenUnread when_unread_;
  std::deque<std::uint8_t> bytes_;
  std::uint64_t dropped_ = 0;
};

}  // namespace echomap::runner
