// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "host/transport/port_list.hpp"

namespace echomap::transport {

/// What a port was when it was opened. Names of ports are given anew: after an unplugging another
/// device may stand at /dev/ttyACM0, and another program's pty at /dev/pts/3.
class PortIdentity {
 public:
  using ListPorts = std::function<std::vector<PortInfo>()>;

  /// Of the port that has this name now; `list` tells which are here.
  explicit PortIdentity(
      const std::string& port, ListPorts list = [] { return list_ports(); });

  /// The name of the same port now. A USB device may come back under any name: it is known by its
  /// serial number, or by the socket it is in where it has none (`is_same_device`). A pty is the
  /// same where its emulator has published a new link, a network address always. Throws
  /// TransportError where the port is not here, or not known to be the same.
  std::string name_now() const;

 private:
  /// Empty where it is no USB device.
  std::optional<PortInfo> device_here() const;
  /// Where `port_` leads to now.
  std::string device_name() const;
  std::string device_name_now() const;
  [[noreturn]] void refuse(const std::string& why) const;

  std::string port_;
  ListPorts list_;
  std::string link_;  ///< Of a pty.
  std::optional<PortInfo> device_;
};

}  // namespace echomap::transport
