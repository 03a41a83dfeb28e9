// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <map>
#include <memory>

namespace echomap::live_page {

/// One client's connection, of HTTP or a WebSocket.
class Connection {
 public:
  virtual ~Connection() = default;
  /// Ends it now.
  virtual void close() = 0;
  /// Since when it has waited for its client to take what was sent; the end of time where it has
  /// not.
  virtual std::chrono::steady_clock::time_point blocked_since() const = 0;
};

/// All connections that are open. Of one thread.
class ConnectionList {
 public:
  /// As long as this lives the connection counts.
  using Place = std::shared_ptr<void>;

  explicit ConnectionList(std::size_t max_connections) : max_connections_(max_connections) {}

  bool is_full() const { return connections_.size() >= max_connections_; }
  std::size_t size() const { return connections_.size(); }
  Place add(const std::weak_ptr<Connection>& connection);
  /// Closes those whose client has taken nothing for so long.
  void close_blocked(std::chrono::steady_clock::duration patience);
  void close_all();

 private:
  std::size_t max_connections_;
  std::map<std::size_t, std::weak_ptr<Connection>> connections_;
  std::size_t next_number_ = 0;
};

/// How many connections there can be at most, so that the files and ports of a run still open.
std::size_t max_connections_of_this_process();

}  // namespace echomap::live_page
