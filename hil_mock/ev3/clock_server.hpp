// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "hil_mock/runner/descriptor.hpp"

namespace echomap::ev3 {

/// Simulated time for programs that sleep by asking for it: a program connects and gets the time,
/// 8 bytes of microseconds, low byte first. To sleep it sends in the same way until when, and gets
/// the time when it is to go on.
class ClockServer {
 public:
  /// Listens on a socket of that name. Throws std::system_error where it cannot.
  explicit ClockServer(const std::filesystem::path& socket);

  /// Waits until everybody who is connected sleeps, and takes new connections in meanwhile, which
  /// begin at `now_us`. Who does not ask for `limit` of real time is left out until it does.
  /// `on_wait` is called now and then.
  void wait_until_all_sleep(std::uint64_t now_us,
                            std::chrono::milliseconds limit,
                            const std::function<void()>& on_wait);

  /// Waits a little for somebody to connect, who begins at `now_us`.
  void wait_for_connection(std::uint64_t now_us);

  /// When the first of them wants to go on; empty where nobody sleeps.
  std::optional<std::uint64_t> next_wake_us() const;
  /// Wakes who is due, and, with `early`, the one that has connected last.
  void wake(std::uint64_t now_us, bool early);

  bool has_clients() const { return !clients_.empty(); }
  /// How many have ever connected.
  std::size_t connections() const { return connections_; }
  void disconnect_all() { clients_.clear(); }

 private:
  struct Client {
    runner::Descriptor socket;
    bool is_asleep = false;
    bool is_hung = false;
    std::uint64_t until_us = 0;
  };

  void accept_all(std::uint64_t now_us);
  void hear_all();
  bool has_busy_one() const;
  void poll_all(std::chrono::milliseconds most) const;

  runner::Descriptor listener_;
  std::vector<Client> clients_;
  std::size_t connections_ = 0;
};

}  // namespace echomap::ev3
