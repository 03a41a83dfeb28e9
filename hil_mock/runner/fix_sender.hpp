// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

namespace echomap::runner {

/// Sends lines to whoever listens on this machine; where nobody does, they are lost. No call waits.
class FixSender {
 public:
  virtual ~FixSender() = default;
  /// `line` has no line end.
  virtual void send(const std::string& line) = 0;
};

/// Of "udp:PORT", datagrams to that port of 127.0.0.1, one a line; of "tcp:PORT", a server there
/// for one client, 0 for a free one. Throws std::invalid_argument for another address and
/// std::system_error where the port is taken.
std::unique_ptr<FixSender> make_fix_sender(const std::string& address);

}  // namespace echomap::runner
