// SPDX-License-Identifier: MIT
#include "host/robot_link/outage_counter.hpp"

namespace echomap::robot_link {

void OutageCounter::note(LinkState state, time::HostTime now) {
  const bool is_ready = state == LinkState::kReady;
  if (!is_ready && was_ready_ && !away_since_) {
    away_since_ = now;
    ++count_;
    earlier_ += last_;
  }
  if (away_since_) {
    last_ = now - *away_since_;
  }
  if (is_ready) {
    was_ready_ = true;
    away_since_.reset();
  }
}

void OutageCounter::add_to(LinkStatistics& statistics) const {
  statistics.outages = count_;
  statistics.outage_time = earlier_ + last_;
}

}  // namespace echomap::robot_link
