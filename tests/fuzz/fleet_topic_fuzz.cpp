// SPDX-License-Identifier: MIT
#include <cstdint>
#include <string>
#include <vector>

#include "host/fleet_messages/topic.hpp"
#include "host/mqtt/fleet_name.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace fleet_messages = echomap::fleet_messages;
using echomap::fuzz::Input;
using echomap::fuzz::require;

/// A topic of each kind of id.
std::vector<Input> echomap::fuzz::seeds() {
  return {input_of("echomap/1/office/r1/presence"),
          input_of("echomap/1/a-fleet_1/robot-9/manifest/65535"),
          input_of("echomap/1/hall/r2/submap/ba7816bf8f01cfea414140de5dae2223"),
          input_of("echomap/1/hall/r2/relay/00000000000000000000000000000000")};
}

/// One input is a topic: it is one that is written the same again, or none.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(data, data + size);
  const auto topic = fleet_messages::parse_topic(text);
  if (topic) {
    require(fleet_messages::format_topic(*topic) == text, "a topic is written the same again");
    require(echomap::mqtt::is_fleet_name(topic->fleet), "a fleet has a name");
    require(echomap::mqtt::is_fleet_name(topic->robot), "a robot has a name");
  }
  return 0;
}
