// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include <sys/socket.h>

#include "host/transport/file_descriptor.hpp"

namespace echomap::tests {

/// One direction of a connection: what was read and is not due yet.
class ProxyPipe {
 public:
  using Clock = std::chrono::steady_clock;

  ProxyPipe(int from, int to) : from_(from), to_(to) {}

  int from() const { return from_; }
  int to() const { return to_; }
  bool wants_bytes() const { return !has_ended_ && held_bytes_ < kMaxHeldBytes; }
  /// Everything was passed on, and nothing will come.
  bool is_done() const { return is_broken_ || (has_ended_ && chunks_.empty()); }
  std::optional<Clock::time_point> due() const {
    return chunks_.empty() ? std::nullopt : std::optional(chunks_.front().due);
  }

  /// Asks for the delay after the bytes: what is sent after it was set is held for so long.
  void read(const std::atomic<std::int64_t>& delay_ms) {
    std::array<char, kChunkBytes> bytes{};
    const ssize_t count = ::recv(from_, bytes.data(), bytes.size(), MSG_DONTWAIT);
    if (count > 0) {
      const auto size = static_cast<std::size_t>(count);
      chunks_.push_back({Clock::now() + std::chrono::milliseconds(delay_ms),
                         {bytes.begin(), bytes.begin() + count}});
      held_bytes_ += size;
    } else if (count == 0 || errno != EAGAIN) {
      has_ended_ = true;
    }
  }

  /// How many bytes of what is due the receiver has taken.
  std::size_t write() {
    std::size_t written = 0;
    while (!chunks_.empty() && chunks_.front().due <= Clock::now()) {
      std::vector<char>& bytes = chunks_.front().bytes;
      const ssize_t count = ::send(to_, bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
      if (count < 0) {
        is_broken_ = errno != EAGAIN;
        break;
      }
      bytes.erase(bytes.begin(), bytes.begin() + count);
      written += static_cast<std::size_t>(count);
      if (bytes.empty()) {
        chunks_.pop_front();
      }
    }
    held_bytes_ -= written;
    return written;
  }

 private:
  struct Chunk {
    Clock::time_point due;
    std::vector<char> bytes;
  };

  /// What one direction holds at most; then the sender waits, as with a full radio.
  static constexpr std::size_t kMaxHeldBytes = std::size_t{4} << 20;
  static constexpr std::size_t kChunkBytes = 65536;

  int from_;
  int to_;
  std::deque<Chunk> chunks_;
  std::size_t held_bytes_ = 0;
  bool has_ended_ = false;
  bool is_broken_ = false;
};

/// A client and the connection to the target that was made for it.
struct ProxiedConnection {
  ProxiedConnection(int client_socket, int target_socket)
      : client(client_socket), target(target_socket) {}

  transport::FileDescriptor client;
  transport::FileDescriptor target;
  std::array<ProxyPipe, 2> pipes{ProxyPipe{client.get(), target.get()},
                                 ProxyPipe{target.get(), client.get()}};
};

}  // namespace echomap::tests
