// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace echomap::transport {

/// What a port was when it was opened. Names of ports are given anew: after an unplugging another
/// device may stand at /dev/ttyACM0, and another program's pty at /dev/pts/3.
class PortIdentity {
 public:
  /// Of the port that has this name now.
  explicit PortIdentity(const std::string& port);

  /// Why the port that has the name now must not be taken for the same robot's; empty where it may:
  /// the same USB device, a pty whose emulator has published a new link, any network address.
  std::string objection() const;

 private:
  std::string port_;
  std::string stamp_;
};

}  // namespace echomap::transport
