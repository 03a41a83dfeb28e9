// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "host/robot_link/link_state.hpp"
#include "host/robot_link/link_statistics.hpp"
#include "host/time/host_time.hpp"

namespace echomap::robot_link {

/// Counts how often and for how long a link that was ready is so no more.
class OutageCounter {
 public:
  /// How the link stands now.
  void note(LinkState state, time::HostTime now);
  /// How long the outage under way has lasted, or the last one did.
  time::HostClock::duration last() const { return last_; }

  /// Fills in the outages, the one under way included.
  void add_to(LinkStatistics& statistics) const;

 private:
  bool was_ready_ = false;
  std::optional<time::HostTime> away_since_;
  std::uint64_t count_ = 0;
  time::HostClock::duration last_{};
  time::HostClock::duration earlier_{};  ///< All but the last.
};

}  // namespace echomap::robot_link
