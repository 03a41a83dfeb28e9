// SPDX-License-Identifier: MIT
#include "host/live_page/client_queue.hpp"

#include <iterator>
#include <utility>

namespace echomap::live_page {

bool ClientQueue::push(Frame frame) {
  if (!frame.channel) {
    bytes_to_keep_ += frame.bytes->size();
    append(std::move(frame));
    first_after_barrier_ = next_number_;
    return bytes_to_keep_ <= max_bytes_;
  }
  const auto found = newest_.find(*frame.channel);
  if (found != newest_.end() && found->second->number >= first_after_barrier_) {
    found->second->frame = std::move(frame);
    return true;
  }
  if (found != newest_.end()) {
    waiting_.erase(found->second);
  }
  const FrameChannel channel = *frame.channel;
  append(std::move(frame));
  newest_[channel] = std::prev(waiting_.end());
  return true;
}

std::optional<Frame> ClientQueue::pop() {
  if (waiting_.empty()) {
    return std::nullopt;
  }
  Frame frame = std::move(waiting_.front().frame);
  waiting_.pop_front();
  if (frame.channel) {
    newest_.erase(*frame.channel);
  } else {
    bytes_to_keep_ -= frame.bytes->size();
  }
  return frame;
}

void ClientQueue::clear() {
  waiting_.clear();
  newest_.clear();
  bytes_to_keep_ = 0;
}

void ClientQueue::append(Frame frame) { waiting_.push_back({std::move(frame), next_number_++}); }

}  // namespace echomap::live_page
