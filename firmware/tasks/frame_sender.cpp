// SPDX-License-Identifier: MIT
#include "firmware/tasks/frame_sender.hpp"

namespace echomap {
namespace tasks {

void FrameSender::delimit() {
  const uint8_t delimiter = 0;
  port_.send(protocol::ByteSpan{&delimiter, 1});
}

}  // namespace tasks
}  // namespace echomap
