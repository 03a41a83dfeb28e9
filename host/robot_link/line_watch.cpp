// SPDX-License-Identifier: MIT
#include "host/robot_link/line_watch.hpp"

namespace echomap::robot_link {

LinkState LineWatch::next_state(LinkState state, time::HostTime now) {
  switch (state) {
    case LinkState::kReady:
      return is_lost(now) ? LinkState::kLost : state;
    case LinkState::kConnecting:
    case LinkState::kSilent:
    case LinkState::kGarbage:
    case LinkState::kUnheard:
      return diagnose(now);
    case LinkState::kBusy:
      return is_within(diagnose_after_, last_frame_at_, now) ? state : diagnose(now);
    case LinkState::kDescribing:
    case LinkState::kMismatch:
    case LinkState::kLost:
      break;
  }
  return state;
}

LinkState LineWatch::diagnose(time::HostTime now) {
  if (!searching_since_) {
    searching_since_ = now;
  }
  if (now - *searching_since_ < diagnose_after_) {
    return LinkState::kConnecting;
  }
  if (is_within(diagnose_after_, last_frame_at_, now)) {
    return LinkState::kUnheard;
  }
  return is_within(diagnose_after_, last_byte_at_, now) ? LinkState::kGarbage : LinkState::kSilent;
}

bool LineWatch::is_hello_due(LinkState state, time::HostTime now) const {
  const bool is_settled = state == LinkState::kMismatch || state == LinkState::kDescribing;
  if (is_settled || now < next_hello_) {
    return false;
  }
  return state != LinkState::kReady || !is_within(quiet_after_, last_frame_at_, now);
}

}  // namespace echomap::robot_link
