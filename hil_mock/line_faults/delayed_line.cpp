// SPDX-License-Identifier: MIT
#include "hil_mock/line_faults/delayed_line.hpp"

#include <algorithm>

namespace echomap::line_faults {

void DelayedLine::send(std::uint8_t byte, std::int64_t now_ns) {
  if (!in_frame_) {
    const std::int64_t now_us = now_ns / 1000;
    frame_delay_ns_ = (model_.arrival_us(now_us) - now_us) * 1000;
  }
  in_frame_ = byte != 0;
  last_arrival_ns_ = std::max(last_arrival_ns_, now_ns + frame_delay_ns_);
  bytes_.push_back({last_arrival_ns_, byte});
}

std::optional<std::int64_t> DelayedLine::next_arrival_ns() const {
  return bytes_.empty() ? std::nullopt : std::optional(bytes_.front().arrival_ns);
}

std::vector<std::uint8_t> DelayedLine::take_arrived(std::int64_t now_ns) {
  std::vector<std::uint8_t> arrived;
  while (!bytes_.empty() && bytes_.front().arrival_ns <= now_ns) {
    arrived.push_back(bytes_.front().byte);
    bytes_.pop_front();
  }
  return arrived;
}

}  // namespace echomap::line_faults
