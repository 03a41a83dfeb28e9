// SPDX-License-Identifier: MIT
#include "host/robot_link/frame_inbox.hpp"

namespace echomap::robot_link {

using protocol::DecodeStatus;

InboxEvent FrameInbox::take(std::uint8_t byte, const std::optional<SchemaDifference>& difference) {
  preview_.add(byte);
  foreign_.add(byte);
  const DecodeStatus status = decoder_.take(byte);
  if (status == DecodeStatus::kFrame) {
    preview_.clear();
    return InboxEvent::kFrame;
  }
  const bool is_damaged = protocol::FrameDecoder::is_error(status);
  const auto foreign_seq =
      is_damaged && difference ? foreign_.recognised(*difference) : std::nullopt;
  if (foreign_seq) {
    preview_.clear();
    ++frames_foreign_;
    count(DecodeStatus::kFrame, *foreign_seq);
    return InboxEvent::kForeign;
  }
  if (is_damaged) {
    count(status, 0);
  }
  return InboxEvent::kNothing;
}

void FrameInbox::add_to(LinkStatistics& statistics) const {
  statistics.frames_received = frames_received_;
  statistics.frames_bad = frames_bad_;
  statistics.frames_lost = frames_lost_;
  statistics.frames_foreign = frames_foreign_;
}

/// The counters of the wire have 16 bits, which a long session wraps.
void FrameInbox::count(DecodeStatus status, std::uint8_t seq) {
  const protocol::ReceiveCounters before = counters_;
  counters_.take(status, seq);
  const auto step = [](std::uint16_t from, std::uint16_t to) {
    return static_cast<std::uint16_t>(to - from);
  };
  frames_received_ += step(before.frames_good(), counters_.frames_good());
  frames_bad_ += step(before.frames_bad(), counters_.frames_bad());
  frames_lost_ += step(before.frames_lost(), counters_.frames_lost());
}

}  // namespace echomap::robot_link
