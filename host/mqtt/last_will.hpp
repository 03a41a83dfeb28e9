// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace echomap::mqtt {

/// Message that the broker publishes, at least once, when a client's connection ends without a
/// DISCONNECT. A broker that is killed publishes no will: whoever watches others needs a heartbeat,
/// too.
struct LastWill {
  std::string topic;
  std::string payload;
  bool retain = true;
};

}  // namespace echomap::mqtt
