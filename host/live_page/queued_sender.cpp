// SPDX-License-Identifier: MIT
#include "host/live_page/queued_sender.hpp"

#include <utility>

namespace echomap::live_page {

QueuedSender::QueuedSender(std::function<void()> wake, std::size_t max_bytes)
    : wake_(std::move(wake)), queue_(max_bytes) {}

void QueuedSender::send(Frame frame) {
  const std::lock_guard lock(mutex_);
  if (closed_) {
    return;
  }
  closed_ = !queue_.push(std::move(frame));
  wake_writer();
}

void QueuedSender::close() {
  const std::lock_guard lock(mutex_);
  if (closed_) {
    return;
  }
  closed_ = true;
  wake_writer();
}

std::optional<Frame> QueuedSender::take() {
  const std::lock_guard lock(mutex_);
  is_awake_ = false;
  return queue_.pop();
}

bool QueuedSender::is_closed() const {
  const std::lock_guard lock(mutex_);
  return closed_;
}

void QueuedSender::detach() {
  const std::lock_guard lock(mutex_);
  closed_ = true;
  queue_.clear();
  wake_ = nullptr;
}

void QueuedSender::wake_writer() {
  // A writer that is busy does not look before it is done, which an end must not wait for.
  if (wake_ && (!is_awake_ || closed_)) {
    is_awake_ = true;
    wake_();
  }
}

}  // namespace echomap::live_page
