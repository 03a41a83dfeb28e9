// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "protocol/command_messages.hpp"

namespace echomap {
namespace drivers {

/// The servo under the sonar, which tells nobody where it is: its travel is taken from its speed.
class PanServo {
 public:
  /// Longest travel that `turn_to` tells, in milliseconds, without the wait for the pulse.
  static constexpr uint16_t kMaxTravelMs = 65000;

  /// True when minimum and maximum have pulses in range.
  static bool accepts(const protocol::ConfigurePan& settings);

  /// Turns to a pan within the limits that `accepts` has granted, in centidegrees to the left;
  /// returns how long that takes, in milliseconds, from the wait for the new pulse on; 0 where the
  /// pulse stays the same. Where it stands before the first turn is unknown: that one counts as the
  /// whole range.
  uint16_t turn_to(const protocol::ConfigurePan& settings, int32_t pan_cdeg);
  /// A turn was not waited for: nobody knows where it stands.
  void lose_track() { pan_known_ = false; }

 private:
  int32_t pan_cdeg_ = 0;
  bool pan_known_ = false;
};

}  // namespace drivers
}  // namespace echomap
