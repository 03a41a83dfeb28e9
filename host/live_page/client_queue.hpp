// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <list>
#include <map>
#include <optional>

#include "host/live_page/frame.hpp"

namespace echomap::live_page {

/// The frames that wait for one client. A slow client gets of each channel only the newest, and
/// no frame earlier than one without a channel that was pushed before it.
class ClientQueue {
 public:
  /// Of frames that must not be left out; a client that lets more pile up does not read.
  static constexpr std::size_t kMaxBytes = std::size_t{1} << 20;

  explicit ClientQueue(std::size_t max_bytes = kMaxBytes) : max_bytes_(max_bytes) {}

  /// False where too much waits: the client has to be closed.
  bool push(Frame frame);
  /// The frame that is next; nothing where none waits.
  std::optional<Frame> pop();
  void clear();

  std::size_t size() const { return waiting_.size(); }
  bool empty() const { return waiting_.empty(); }

 private:
  struct Waiting {
    Frame frame;
    std::uint64_t number = 0;
  };
  using Place = std::list<Waiting>::iterator;

  void append(Frame frame);

  std::size_t max_bytes_;
  std::list<Waiting> waiting_;
  std::map<FrameChannel, Place> newest_;
  std::uint64_t next_number_ = 0;
  std::uint64_t first_after_barrier_ = 0;  ///< A frame before that may not take a newer content.
  std::size_t bytes_to_keep_ = 0;
};

}  // namespace echomap::live_page
