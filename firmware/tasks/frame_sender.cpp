// SPDX-License-Identifier: MIT
#include "firmware/tasks/frame_sender.hpp"

namespace echomap {
namespace tasks {

bool FrameSender::answer(const uint8_t* payload, uint8_t id, uint8_t size, uint16_t seed) {
  const uint8_t frame_bytes = static_cast<uint8_t>(size + protocol::kFrameOverhead);
  const bool may_go = has_room(static_cast<uint8_t>(frame_bytes + kTelemetryBytes)) ||
                      budget_.take_answer(frame_bytes);
  return may_go && send(payload, id, size, seed);
}

bool FrameSender::tell(const uint8_t* payload, uint8_t id, uint8_t size, uint16_t seed) {
  const uint8_t frame_bytes = static_cast<uint8_t>(size + protocol::kFrameOverhead);
  return has_room(frame_bytes) && budget_.take(frame_bytes) && send(payload, id, size, seed);
}

bool FrameSender::send(const uint8_t* payload, uint8_t id, uint8_t size, uint16_t seed) {
  if (port_.send_room() < size + protocol::kFrameOverhead) {
    return false;
  }
  protocol::FrameEncoder encoder;
  return port_.send(encoder.encode(payload, id, size, seed, seq_++));
}

void FrameSender::delimit() {
  const uint8_t delimiter = 0;
  port_.send(protocol::ByteSpan{&delimiter, 1});
}

}  // namespace tasks
}  // namespace echomap
