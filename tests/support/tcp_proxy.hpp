// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace echomap::tests {

/// Passes TCP connections on to a port of this machine, in a thread of its own, and does to them
/// what a bad network does; a user needs no rights for it, as netem wants them.
class TcpProxy {
 public:
  /// Listens on any free port of 127.0.0.1. Throws std::system_error.
  explicit TcpProxy(std::uint16_t target_port);
  /// Ends all connections.
  ~TcpProxy();
  TcpProxy(const TcpProxy&) = delete;
  TcpProxy& operator=(const TcpProxy&) = delete;

  std::uint16_t port() const;

  /// Bytes that come from now on are passed on so much later, in each direction.
  void set_delay(std::chrono::milliseconds delay);
  /// Passes nothing on until resume(); connections stay, and new ones are taken and get no answer.
  /// What comes meanwhile comes afterwards: it is the radio that is away, nobody ends.
  void stall();
  /// Resets all connections, and new ones at once, until resume().
  void cut();
  void resume();

  /// Bytes passed on so far, in both directions.
  std::size_t passed_bytes() const;
  /// Connections made through it so far.
  std::size_t connections() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace echomap::tests
