// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "protocol/command_messages.hpp"
#include "protocol/telemetry_messages.hpp"

namespace echomap {
namespace control {

/// What a wheel did in a control period.
struct WheelPeriod {
  int32_t reference_step;  ///< 1/4000 tick.
  int16_t duty;            ///< -255 .. 255, what it now gets.
  int16_t turned_ticks;
  int16_t turned_ticks_of_4;  ///< In the last four periods.
};

/// Sees when one wheel does what no command explains: a blocked wheel or a dead encoder, motor or
/// encoder the wrong way round, a broken driver. Ramps, braking and reversals are none of these.
class WheelGuard {
 public:
  /// A wheel that gets half of the supply turns, whatever its load.
  static constexpr int16_t kDrivenDuty = 128;

  /// A motion begins: what came before does not count.
  void reset() { *this = WheelGuard(); }

  /// Once a control period; kNone, kStalled, kRunaway or kOverSpeed.
  protocol::MotionOutcome classify(const protocol::ConfigureSafety& limits, const WheelPeriod& now);

 private:
  uint16_t against_ticks_ = 0;
  uint16_t silent_ms_ = 0;
};

}  // namespace control
}  // namespace echomap
