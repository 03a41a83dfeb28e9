// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <mutex>
#include <optional>

#include "host/live_page/client_queue.hpp"
#include "host/live_page/socket_protocol.hpp"

namespace echomap::live_page {

/// Frames from any thread for the thread that writes them. A client that lets too much pile up is
/// closed.
class QueuedSender final : public FrameSender {
 public:
  /// `wake` is called, by the thread that sends, where the writer has to look; it must not wait.
  explicit QueuedSender(std::function<void()> wake, std::size_t max_bytes = ClientQueue::kMaxBytes);

  void send(Frame frame) override;
  void close() override;

  /// The writer's: the frame that is next.
  std::optional<Frame> take();
  /// The writer's: whether the client has to be closed.
  bool is_closed() const;
  /// The writer's: there is no client any more. `wake` is not called after this.
  void detach();

 private:
  void wake_writer();

  mutable std::mutex mutex_;
  std::function<void()> wake_;
  ClientQueue queue_;
  bool is_awake_ = false;  ///< The writer has been told, and has not looked yet.
  bool closed_ = false;
};

}  // namespace echomap::live_page
