// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace echomap::mqtt {

/// What the broker publishes, at least once, when a client's connection ends without its goodbye. A
/// broker that is killed publishes no will: whoever watches others needs a heartbeat too.
struct LastWill {
  std::string topic;
  std::string payload;
  bool retain = true;
};

}  // namespace echomap::mqtt
