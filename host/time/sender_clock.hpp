// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "host/time/host_time.hpp"

namespace echomap::time {

/// Places the clock of somebody who only sends on the host's. What is sent arrives no earlier: the
/// message that was fastest of the last minute tells how far the clocks are apart, too late by as
/// much as it took (Cristian 1989 without the way back). Clocks drift apart by a few milliseconds
/// in that time.
class SenderClock {
 public:
  /// A message that was sent at `sent_s` of the sender's clock has arrived. False where that is
  /// more than a second off and so of no use; the third in a row that agrees is of the sender's new
  /// clock, as after a restart.
  bool add(double sent_s, HostTime arrived);
  /// An instant of the sender on the host's clock; empty before the first message.
  std::optional<HostTime> host_time(double sender_s) const;

 private:
  bool is_another_clock(double apart_s);

  struct Offset {
    HostTime arrived;
    double apart_s = 0.0;  ///< Host less sender.
  };

  std::deque<Offset> offsets_;  ///< Of the last minute; each less than those before it had been.
  double other_apart_s_ = 0.0;  ///< Of the messages in a row that are far off.
  int others_ = 0;
};

}  // namespace echomap::time
