// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "host/robot_link/byte_preview.hpp"
#include "host/robot_link/foreign_frames.hpp"
#include "host/robot_link/link_statistics.hpp"
#include "protocol/link.hpp"

namespace echomap::robot_link {

/// What one received byte completed.
enum class InboxEvent : std::uint8_t {
  kNothing,  ///< No frame, or a damaged one.
  kFrame,    ///< `frame()` is one of ours.
  kForeign,  ///< A whole one that only the robot understands.
};

/// What the host receives: takes bytes apart into frames and counts what was lost.
class FrameInbox {
 public:
  /// `difference` tells the robot's own messages, where it has any.
  InboxEvent take(std::uint8_t byte, const std::optional<SchemaDifference>& difference);
  /// Counts the frame of the last byte; to be called after it was handled, for it may announce a
  /// reset and so a new sequence.
  void count_frame() { count(protocol::DecodeStatus::kFrame, decoder_.frame().seq); }
  /// Valid until the next byte.
  protocol::Frame frame() const { return decoder_.frame(); }

  /// The robot begins a new sequence: a jump is no loss.
  void restart() { counters_.restart(); }

  /// Fills in what came.
  void add_to(LinkStatistics& statistics) const;
  /// What came since the last frame.
  const BytePreview& preview() const { return preview_; }

 private:
  void count(protocol::DecodeStatus status, std::uint8_t seq);

  protocol::FrameDecoder decoder_{protocol::MessagesToHost::find_schema};
  protocol::ReceiveCounters counters_;
  ForeignFrames foreign_;
  BytePreview preview_;
  std::uint64_t frames_received_ = 0;
  std::uint64_t frames_bad_ = 0;
  std::uint64_t frames_lost_ = 0;
  std::uint64_t frames_foreign_ = 0;
};

}  // namespace echomap::robot_link
