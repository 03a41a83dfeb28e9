// SPDX-License-Identifier: MIT
#include "protocol/link.hpp"

namespace echomap {
namespace protocol {

void ReceiveCounters::take(DecodeStatus status, uint8_t seq) {
  if (FrameDecoder::is_error(status)) {
    ++frames_bad_;
  }
  if (status != DecodeStatus::kFrame) {
    return;
  }
  if (synchronised_) {
    frames_lost_ = static_cast<uint16_t>(frames_lost_ + static_cast<uint8_t>(seq - expected_seq_));
  }
  synchronised_ = true;
  expected_seq_ = static_cast<uint8_t>(seq + 1);
  ++frames_good_;
}

bool CommandFilter::begin_session(uint16_t session) {
  hold(true);
  if (has_session_ && session == session_) {
    return false;
  }
  has_session_ = true;
  session_ = session;
  last_id_ = 0;
  return true;
}

void CommandFilter::remember(uint8_t command_id, CommandStatus status) {
  last_id_ = command_id;
  last_status_ = status;
}

}  // namespace protocol
}  // namespace echomap
