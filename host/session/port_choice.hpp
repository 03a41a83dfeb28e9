// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "host/transport/byte_stream.hpp"

namespace echomap::session {

/// Ports at which a robot may be.
struct CandidatePorts {
  std::vector<std::string> ports;
  bool are_named = false;  ///< By the user, who knows what they are.
};

/// The ports that `--port` names: a path or address as it is, "id:TEXT" for the one USB port whose
/// serial number or description holds TEXT, all USB and Bluetooth ports of the machine where
/// nothing is named. Throws CommandError 3 where "id:TEXT" fits none or several.
CandidatePorts candidate_ports(const std::vector<std::string>& named);

/// Opens a port; throws transport::TransportError.
using OpenPort = std::function<std::unique_ptr<transport::ByteStream>(const std::string& port)>;

/// The one port at which a robot answers. A single port that the user named is opened and taken as
/// it is. Of all others each hears one Hello of `session`, and the one that answers within 2.5 s,
/// which a board needs that its opening has reset, is chosen. Throws CommandError 3, with what each
/// of them said, where none answers or more than one, and TransportError where a single one cannot
/// be opened.
std::unique_ptr<transport::ByteStream> choose_port(const CandidatePorts& candidates,
                                                   const OpenPort& open,
                                                   std::uint16_t session);

}  // namespace echomap::session
