// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hil_mock/runner/byte_endpoint.hpp"
#include "hil_mock/runner/descriptor.hpp"
#include "hil_mock/runner/outgoing_bytes.hpp"

namespace echomap::runner {

/// A TCP port on 127.0.0.1 that serves one host at a time.
class TcpEndpoint : public ByteEndpoint {
 public:
  /// Listens on `port`; 0 takes a free one. Throws std::system_error where it is taken.
  TcpEndpoint(std::uint16_t port, WhenUnread when_unread);

  std::vector<std::uint8_t> receive() override;
  void send(std::span<const std::uint8_t> bytes) override;
  std::string address() const override { return "tcp://127.0.0.1:" + std::to_string(port_); }
  int descriptor() const override;
  bool is_sending() const override { return client_.is_open() && !outgoing_.empty(); }
  std::uint64_t dropped_bytes() const override { return outgoing_.dropped(); }

 private:
  void accept_client();

  WhenUnread when_unread_;
  OutgoingBytes outgoing_;
  Descriptor listener_;
  Descriptor client_;
  std::uint16_t port_ = 0;
};

}  // namespace echomap::runner
