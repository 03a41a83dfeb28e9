// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/transport/byte_stream.hpp"
#include "host/transport/port_list.hpp"

namespace echomap::session {

/// What a port is chosen by where the user names none. Nothing of it opens a port.
struct PortSurroundings {
  std::vector<transport::PortInfo> ports;  ///< Those of this machine.
  /// Whether a robot has answered there before.
  std::function<bool(const transport::PortInfo&)> is_known;
  /// Whether another process has it open.
  std::function<bool(const transport::PortInfo&)> is_held;
  /// Asks the person at the terminal; empty where there is none.
  std::function<std::optional<std::string>(const std::string& question)> ask;
  /// Why a robot that is plugged in may have no port here, with the remedy; may be empty.
  std::string why_none = {};
};

/// Those of this machine.
PortSurroundings surroundings_here();

/// The ports at which a robot can be: of a USB id that boards have, and whatever else a robot has
/// answered at before, as a Bluetooth port that the user once named.
std::vector<transport::PortInfo> possible_robots(const PortSurroundings& here);

/// Chooses one of the possible robots, and writes to none: the only one that has answered before
/// and is free; else the one that the user agrees to or chooses from a list. Throws CommandError 3
/// where there is none, and where nobody can be asked.
std::string choose_possible_robot(const PortSurroundings& here);

/// The ports that `--port` names: a path or address as it is, "id:TEXT" for the one USB port whose
/// serial number or description holds TEXT; where nothing is named, the possible robot that is
/// chosen. Throws CommandError 3 where "id:TEXT" fits none or several.
std::vector<std::string> candidate_ports(const std::vector<std::string>& named,
                                         const PortSurroundings& here);

/// Opens a port; throws transport::TransportError.
using OpenPort = std::function<std::unique_ptr<transport::ByteStream>(const std::string& port)>;

/// The one port at which a robot answers. A single one is opened and taken as it is. Of several,
/// all of which the user has named, each hears one Hello of `session`, and the one that answers
/// within 2.5 s, which a board needs that its opening has reset, is chosen; with `at_any_speed`
/// those that are silent then hear one at each other speed of kRobotBauds. Throws CommandError 3,
/// with what each of them said, where none answers or more than one, and TransportError where a
/// single one cannot be opened.
std::unique_ptr<transport::ByteStream> choose_port(const std::vector<std::string>& ports,
                                                   const OpenPort& open,
                                                   std::uint16_t session,
                                                   bool at_any_speed = false);

}  // namespace echomap::session
