// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/live_page/run_publisher.hpp"
#include "host/robot_link/link_state.hpp"
#include "host/session/operator_control.hpp"

namespace echomap::live_page {

/// What events are told by.
struct EventFacts {
  robot_link::LinkState link = robot_link::LinkState::kConnecting;
  std::uint64_t resets = 0;
  bool is_touching = false;
  bool is_lifted = false;
  bool sonar_is_dead = false;          ///< RobotContext::sonar_is_dead
  bool left_encoder_is_dirty = false;  ///< RobotContext::dirty_encoder
  bool right_encoder_is_dirty = false;
  std::size_t maps_changed = 0;  ///< RobotAtlas::changes, since the run began.
  std::size_t maps_joined = 0;   ///< RobotAtlas::joins, since the run began.
  session::StandReason stands = session::StandReason::kNone;
};

/// Tells what has happened between two looks at a run, with cause and remedy.
class EventWatch {
 public:
  std::vector<RunEvent> look_at(const EventFacts& facts);

 private:
  EventFacts before_;
};

}  // namespace echomap::live_page
