// SPDX-License-Identifier: MIT
#include "firmware/tasks/frame_sender.hpp"

namespace echomap {
namespace tasks {

bool FrameSender::send(
    const uint8_t* payload, uint8_t id, uint8_t size, uint16_t seed, uint8_t reserve) {
  if (port_.send_room() < size + protocol::kFrameOverhead + reserve) {
    return false;
  }
  return port_.send(encoder_.encode(payload, id, size, seed, seq_++));
}

void FrameSender::delimit() {
  const uint8_t delimiter = 0;
  port_.send(protocol::ByteSpan{&delimiter, 1});
}

}  // namespace tasks
}  // namespace echomap
