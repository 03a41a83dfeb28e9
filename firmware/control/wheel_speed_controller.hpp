// SPDX-License-Identifier: MIT
#pragma once

#include <stdint.h>

#include "protocol/command_messages.hpp"

namespace echomap {
namespace control {

/// Makes one wheel follow a reference: duty = feed forward x reference speed + proportional x speed
/// error + integral x lag. The lag is the reference's way minus the wheel's, counted and not summed
/// from speeds, so that no tick is ever lost. Gains as in protocol::ConfigureDrive.
class WheelSpeedController {
 public:
  /// A wheel this near to a standing reference has arrived.
  static constexpr uint8_t kArrivedTicks = 2;

  /// For how many periods without a tick it must have stood there: it coasts less than a tick then.
  static constexpr uint8_t kStillPeriods = 12;

  /// Forgets the lag: the wheel is where it should be.
  void reset();

  /// One control period: how far the reference goes in it (1/4000 tick), and by how many ticks the
  /// wheel has turned in the last one. Returns the duty.
  int16_t update(const protocol::ConfigureDrive& gains, int32_t reference_step, int16_t turned);

  /// The wheel stands within kArrivedTicks of its reference.
  bool arrived() const;
  /// The wheel is farther behind than a turning wheel can be, or does not break away.
  bool stalled(const protocol::ConfigureDrive& limits) const;

 private:
  /// Speed is taken over this many periods: one tick in one period would be 250 ticks/s.
  static constexpr uint8_t kSpeedPeriodsLog2 = 2;
  static constexpr uint8_t kSpeedPeriods = 1U << kSpeedPeriodsLog2;

  void measure(int16_t turned);
  void push_off(bool reference_moves);
  bool near() const;

  int32_t lag_ = 0;   ///< 1/4000 tick.
  int32_t push_ = 0;  ///< Duty x 256 against static friction.
  int16_t turned_[kSpeedPeriods] = {};
  int16_t turned_sum_ = 0;  ///< Over kSpeedPeriods.
  uint8_t oldest_ = 0;
  uint8_t still_periods_ = kStillPeriods;
};

}  // namespace control
}  // namespace echomap
