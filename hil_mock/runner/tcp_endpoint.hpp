// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hil_mock/runner/byte_endpoint.hpp"
#include "hil_mock/runner/descriptor.hpp"
#include "hil_mock/runner/outgoing_bytes.hpp"

namespace echomap::runner {

/// A TCP port on 127.0.0.1, as of a bridge that several hosts may reach: the robot hears all of
/// them, and each hears all that it says from then on. Before the first host nothing is lost where
/// `WhenUnread::kKeep` is wanted.
class TcpEndpoint : public ByteEndpoint {
 public:
  /// Listens on `port`; 0 takes a free one. Throws std::system_error where it is taken.
  TcpEndpoint(std::uint16_t port, WhenUnread when_unread);

  std::vector<std::uint8_t> receive() override;
  void send(std::span<const std::uint8_t> bytes) override;
  std::string address() const override { return "tcp://127.0.0.1:" + std::to_string(port_); }
  int descriptor() const override { return ready_.number(); }
  bool is_sending() const override;
  std::uint64_t dropped_bytes() const override;

 private:
  struct Client {
    Descriptor socket;
    OutgoingBytes outgoing;
  };

  void accept_clients();
  void watch(int descriptor);
  /// False where it has gone.
  static bool read_from(const Client& client, std::vector<std::uint8_t>& bytes);

  WhenUnread when_unread_;
  Descriptor ready_;  ///< Of epoll: readable when one of the others is.
  Descriptor listener_;
  std::vector<Client> clients_;
  OutgoingBytes before_first_;
  std::uint64_t dropped_ = 0;  ///< By those that have gone, and while nobody was there.
  std::uint16_t port_ = 0;
};

}  // namespace echomap::runner
