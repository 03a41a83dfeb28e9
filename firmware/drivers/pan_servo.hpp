// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "protocol/command_messages.hpp"

namespace echomap {
namespace drivers {

/// The servo under the sonar, which tells nobody where it is: its travel is taken from its speed.
class PanServo {
 public:
  /// `settings` is where the active ones stand.
  constexpr explicit PanServo(protocol::ConfigurePan& settings) : settings_(settings) {}

  /// True when every pan from its minimum to its maximum has a pulse in range, and a speed.
  static bool accepts(const protocol::ConfigurePan& settings);
  /// Takes settings that `accepts` has granted.
  void configure(const protocol::ConfigurePan& settings) {
    settings_ = settings;
    lose_track();
  }

  /// True for a pan within the settings' limits, in centidegrees to the left.
  bool reaches(int32_t pan_cdeg) const;
  /// Turns to a pan that `reaches` has granted; returns how long that takes, in milliseconds.
  /// Where it stands before the first turn is unknown: that one counts as the whole range.
  uint16_t turn_to(int32_t pan_cdeg);
  /// A turn was not waited for: nobody knows where it stands.
  void lose_track() { pan_known_ = false; }

 private:
  protocol::ConfigurePan& settings_;
  int32_t pan_cdeg_ = 0;
  bool pan_known_ = false;
};

}  // namespace drivers
}  // namespace echomap
