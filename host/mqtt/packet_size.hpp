// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace echomap::mqtt {

/// Bytes of a PUBLISH packet without properties, at least once (MQTT 5, section 3.3): what a broker
/// compares with the maximum packet size of its CONNACK. At most once takes two bytes less.
std::size_t publish_packet_bytes(std::size_t topic_bytes, std::size_t payload_bytes);

}  // namespace echomap::mqtt
