// SPDX-License-Identifier: MIT
#include "host/robot_link/frame_outbox.hpp"

namespace echomap::robot_link {

void FrameOutbox::confirm(const protocol::HelloReply& reply) {
  credit_.confirm({reply.kId, 0});
  credit_.grant(reply.receive_credit_bytes);
}

void FrameOutbox::add_to(LinkStatistics& statistics) const {
  statistics.frames_sent = frames_sent_;
  statistics.credit_waits = waits_;
  statistics.credit_released_bytes = credit_.released_bytes();
}

}  // namespace echomap::robot_link
