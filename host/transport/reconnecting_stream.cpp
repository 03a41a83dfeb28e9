// SPDX-License-Identifier: MIT
#include "host/transport/reconnecting_stream.hpp"

#include <algorithm>
#include <thread>
#include <utility>

#include "host/transport/transport_error.hpp"

namespace echomap::transport {

using std::chrono::steady_clock;

ReconnectingStream::ReconnectingStream(std::unique_ptr<ByteStream> first, Open open)
    : open_(std::move(open)), below_(std::move(first)), name_(below_->name()) {}

std::size_t ReconnectingStream::read_some(std::span<std::uint8_t> into,
                                          std::chrono::microseconds wait) {
  if (!below_) {
    const auto until = std::min(steady_clock::now() + wait, next_try_);
    std::this_thread::sleep_until(until);
    try_to_open();
    return 0;
  }
  const std::size_t count = below_->read_some(into, wait);
  look_below();
  return count;
}

void ReconnectingStream::write(std::span<const std::uint8_t> bytes) {
  if (below_) {
    below_->write(bytes);
    look_below();
  }
}

/// A closed stream may still hold bytes, but frames of before the break are of no use after it.
void ReconnectingStream::look_below() {
  if (below_->status() == StreamStatus::kClosed) {
    reason_ = below_->close_reason();
    below_.reset();
    next_try_ = steady_clock::now() + kRetryPeriod;
  }
}

void ReconnectingStream::try_to_open() {
  if (steady_clock::now() < next_try_) {
    return;
  }
  try {
    below_ = open_();
    reason_.clear();
    ++reconnects_;
  } catch (const TransportError& error) {
    reason_ = error.why();
    next_try_ = steady_clock::now() + kRetryPeriod;
  }
}

}  // namespace echomap::transport
