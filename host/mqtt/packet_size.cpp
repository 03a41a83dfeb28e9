// SPDX-License-Identifier: MIT
#include "host/mqtt/packet_size.hpp"

namespace echomap::mqtt {

std::size_t publish_packet_bytes(std::size_t topic_bytes, std::size_t payload_bytes) {
  constexpr std::size_t kTopicLength = 2;
  constexpr std::size_t kPacketId = 2;
  constexpr std::size_t kPropertyLength = 1;
  const std::size_t remaining =
      kTopicLength + topic_bytes + kPacketId + kPropertyLength + payload_bytes;
  // Type and flags, then the remaining length with seven bits a byte.
  std::size_t header = 2;
  for (std::size_t rest = remaining >> 7U; rest > 0; rest >>= 7U) {
    ++header;
  }
  return header + remaining;
}

}  // namespace echomap::mqtt
