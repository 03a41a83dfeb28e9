// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "protocol/handshake_messages.hpp"
#include "protocol/version.hpp"

namespace echomap::session {

/// Name and version of the firmware in a robot's own words: "echomap 0.1.0".
inline std::string firmware_of(const protocol::HelloReply& robot) {
  return std::string("echomap ") + protocol::VersionText(robot.firmware_version).text();
}

}  // namespace echomap::session
